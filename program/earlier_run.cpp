#include "program/earlier_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iostream>

#include "base/errors.hpp"

namespace crawford {

EarlierRun::EarlierRun(const VerifyOptions& options) : every_study_(options.studies.empty()) {
    yardstick_.exact = options.exact;
    if (options.grown) yardstick_.grown = *options.grown;
    if (!std::isfinite(yardstick_.grown) || yardstick_.grown < 1.0)
        throw InputError(
            fmt::format("--grown = {} must be a factor of 1 or more, as 1.05", yardstick_.grown));
    if (options.against) gates_ = reports::read_gates(*options.against);
}

bool EarlierRun::tell(const reports::Verification& found, bool grids_were_chosen) const {
    if (!gates_) return true;
    reports::Scope scope;
    scope.every_study = every_study_;
    scope.own_grids = !grids_were_chosen;
    for (const auto& study : found.studies) scope.studies.push_back(study.name);
    const auto comparison = reports::compare(*gates_, found.gates, scope, yardstick_);
    std::cout << '\n' << reports::text(comparison);
    return !comparison.fell_short();
}

}  // namespace crawford
