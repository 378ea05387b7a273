/// Which study would see a fault in which term of the equations.
#pragma once

#include <string>
#include <vector>

namespace crawford::reports {

/// A study and the terms that it covers.
struct CoveredBy {
    std::string study;
    std::vector<std::string> terms;

    bool covers(const std::string& term) const;
};

class Coverage {
public:
    /// `terms` are the rows: all terms of the model's equations.
    Coverage(std::vector<std::string> terms, std::vector<CoveredBy> studies);

    const std::vector<std::string>& terms() const { return terms_; }
    const std::vector<CoveredBy>& studies() const { return studies_; }

    bool covers(const CoveredBy& study, const std::string& term) const;
    /// How many studies cover the term.
    std::size_t count(const std::string& term) const;

    /// What is wrong, a line each: a term that no study covers, a study that covers no term, or one
    /// that is none of the model's.
    std::vector<std::string> gaps() const;

private:
    std::vector<std::string> terms_;
    std::vector<CoveredBy> studies_;
};

}  // namespace crawford::reports
