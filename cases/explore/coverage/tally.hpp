/// The estimates, tallied over two halves of the known problems: one to choose on, one to report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/interval_coverage.hpp"

namespace crawford {

struct NamedEstimator {
    std::string name;
    reports::Estimator estimate;
};

/// Those of reports/estimate.hpp.
std::vector<NamedEstimator> estimators();

/// Every other problem by kind and name, so that no run is in both and all kinds with two problems
/// are. Nothing that could be fitted to what comes out.
struct Halves {
    std::vector<reports::KnownSeries> choosing, reporting;
};
/// \param all in the order of their problems
Halves halves_of(const std::vector<reports::KnownSeries>& all);

/// One estimate over all sets of so many grids.
struct TalliedEstimate {
    std::string name;
    std::size_t grids;
    reports::CoverageTally choosing, reporting;
    /// By which the intervals must be multiplied to hold 95 % of the choosing half; nothing where
    /// that many sets are not answered.
    std::optional<double> factor = {};
    /// The reporting half with that factor.
    std::optional<reports::CoverageTally> calibrated = {};
};
std::vector<TalliedEstimate> tally(const Halves& halves);

inline constexpr double wanted_coverage = 0.95;

/// The rule: of those that hold `wanted_coverage` of the choosing half with three grids and with
/// four, that with the smaller median width with three; none, if none does.
std::optional<std::string> choice(const std::vector<TalliedEstimate>& tallied);

}  // namespace crawford
