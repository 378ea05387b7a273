#include "reports/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace crawford::reports {
namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

}  // namespace

Coverage::Coverage(std::vector<std::string> terms, std::vector<CoveredBy> studies)
    : terms_(std::move(terms)), studies_(std::move(studies)) {}

bool CoveredBy::covers(const std::string& term) const {
    return holds(terms, term);
}

std::size_t Coverage::count(const std::string& term) const {
    return std::size_t(std::ranges::count_if(
        studies_, [&](const CoveredBy& study) { return study.covers(term); }));
}

std::vector<std::string> Coverage::gaps() const {
    std::vector<std::string> gaps;
    for (const auto& term : terms_)
        if (count(term) == 0) gaps.push_back(fmt::format("no study covers \"{}\"", term));
    for (const auto& study : studies_) {
        if (study.terms.empty())
            gaps.push_back(fmt::format("study \"{}\" does not say what it covers", study.study));
        for (const auto& term : study.terms)
            if (!holds(terms_, term))
                gaps.push_back(
                    fmt::format("study \"{}\" covers \"{}\", which is no term of the model",
                                study.study, term));
    }
    return gaps;
}

}  // namespace crawford::reports
