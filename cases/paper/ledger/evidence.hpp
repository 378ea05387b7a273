/// What the claims of the paper are judged by: records, and what was made of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/paper/ledger/subject.hpp"
#include "reports/claim.hpp"

namespace crawford::ledger {

struct Evidence {
    /// The number that a drawn case has found under a name.
    /// \throws std::logic_error if the case has not found it.
    std::function<double(const std::string& entry, const std::string& what)> finding;
    std::vector<reports::Refinement> refinements = {};
    std::vector<reports::Spread> spreads = {};
    reports::ReadingMatrix pack_readings = {};
    reports::ReadingMatrix sandwich_readings = {};

    /// finding() of one case.
    std::function<double(const std::string& what)> findings_of(const std::string& entry) const;
};

using Rows = std::vector<reports::LedgerRow>;

/// A closed form has neither grid nor step.
inline constexpr reports::Uncertainty exact{.grid = 0.0, .step = 0.0};

/// The index of a quantity in a direction; nothing if it was not refined there or diverges: what
/// has no limit has no distance to it.
std::optional<double> index(const Evidence& evidence, const std::string& of, const Measure& measure,
                            const std::string& direction);

/// A sentence with the values on all grids if a quantity diverges in a direction, else nothing.
std::string divergence(const Evidence& evidence, const std::string& of, const Measure& measure,
                       const std::string& direction);

/// What a quantity of a matrix becomes under each other reading, those that change least first.
/// \throws std::logic_error if the matrix has no such quantity.
std::vector<reports::OtherReading> others(const reports::ReadingMatrix& matrix,
                                          const std::string& quantity);
/// The same with another one before all of them; with all values times a factor, plus an offset.
std::vector<reports::OtherReading> before(reports::OtherReading first,
                                          std::vector<reports::OtherReading> others);
std::vector<reports::OtherReading> times(std::vector<reports::OtherReading> others, double factor);
std::vector<reports::OtherReading> plus(std::vector<reports::OtherReading> others, double offset);

/// Strains are printed in per cent.
inline double percent(double strain) {
    return 100.0 * strain;
}

}  // namespace crawford::ledger
