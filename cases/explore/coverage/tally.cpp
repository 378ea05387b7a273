#include "cases/explore/coverage/tally.hpp"

#include <algorithm>
#include <cmath>

namespace crawford {

namespace {

using reports::Estimate;
using reports::GridValues;
using reports::KnownSeries;

/// The smallest factor that holds so much of the weight.
std::optional<double> factor_for(double share, std::vector<reports::WeightedFactor> factors) {
    std::ranges::sort(factors, {}, &reports::WeightedFactor::factor);
    double all = 0.0, held = 0.0;
    for (const auto& f : factors) all += f.weight;
    for (const auto& f : factors) {
        held += f.weight;
        if (held >= share * all)
            return std::isfinite(f.factor) ? std::optional(f.factor) : std::nullopt;
    }
    return {};
}

reports::Estimator widened(const reports::Estimator& estimator, double factor) {
    return [=](const GridValues& grids, double order) {
        Estimate estimate = estimator(grids, order);
        estimate.uncertainty *= factor;
        return estimate;
    };
}

bool reaches(const std::vector<TalliedEstimate>& tallied, const std::string& name) {
    return std::ranges::all_of(tallied, [&](const TalliedEstimate& t) {
        return t.name != name || t.choosing.coverage >= wanted_coverage;
    });
}

}  // namespace

std::vector<NamedEstimator> estimators() {
    return {{"celik-2008", [](const GridValues& g, double) { return reports::celik_2008(g); }},
            {"roache", reports::roache},
            {"xing-stern-2010", reports::xing_stern_2010},
            {"eca-hoekstra-2014",
             [](const GridValues& g, double) { return reports::eca_hoekstra_2014(g); }}};
}

Halves halves_of(const std::vector<KnownSeries>& all) {
    Halves halves;
    std::string problem;
    bool is_for_choice = false;
    for (const KnownSeries& series : all) {
        if (series.problem != problem) is_for_choice = !is_for_choice;
        problem = series.problem;
        if (reports::left_out(series).empty())
            (is_for_choice ? halves.choosing : halves.reporting).push_back(series);
    }
    return halves;
}

std::vector<TalliedEstimate> tally(const Halves& halves) {
    std::vector<TalliedEstimate> all;
    for (const std::size_t grids : {3, 4})
        for (const auto& [name, estimate] : estimators()) {
            TalliedEstimate t{name, grids, coverage_of(estimate, halves.choosing, grids),
                              coverage_of(estimate, halves.reporting, grids)};
            t.factor = factor_for(wanted_coverage, factors_of(estimate, halves.choosing, grids));
            if (t.factor)
                t.calibrated = coverage_of(widened(estimate, *t.factor), halves.reporting, grids);
            all.push_back(t);
        }
    return all;
}

std::optional<std::string> choice(const std::vector<TalliedEstimate>& tallied) {
    const TalliedEstimate* best = nullptr;
    for (const TalliedEstimate& t : tallied)
        if (t.grids == 3 && reaches(tallied, t.name) &&
            (!best || t.choosing.median_width < best->choosing.median_width))
            best = &t;
    return best ? std::optional(best->name) : std::nullopt;
}

}  // namespace crawford
