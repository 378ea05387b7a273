#include "cases/explore/tradeoff/judged.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/errors.hpp"
#include "cases/scenes/slab.hpp"
#include "cases/units.hpp"
#include "reference/burning_sandwich_front.hpp"
#include "reference/slab.hpp"

namespace crawford::tradeoff {

namespace {

using namespace units;

Truth of_slab() {
    const reference::Slab exact(slab("AP", {.cells = 1})
                                    .burning_by_law()
                                    .heated(200.0 * cal / (s * cm2))
                                    .pressed(2.0 * MPa)
                                    .conditions(reference::SlabModel::eulerian));
    return {.source = "the exact slab",
            .values = {{quantity::regression_rate, exact.burn_rate()},
                       {quantity::mean_burn_rate, exact.burn_rate()},
                       {quantity::max_temperature, exact.surface_temperature()}},
            .uncertainty = {},
            .profile = {}};
}

Truth of_free_boundary(const Subject& subject) {
    const auto geometry = reference::paper_sandwich();
    const reference::BurningSandwichFront exact(geometry, reference::paper_flame());
    const double half = 120.0 * um;
    Truth truth{.source = "the free-boundary problem",
                .values = {{quantity::regression_rate, exact.regression_rate()},
                           {quantity::mean_burn_rate, exact.mean_burn_rate()}},
                .uncertainty = {{quantity::regression_rate,
                                 exact.regression_rate_uncertainty() / exact.regression_rate()}},
                .profile = {}};
    double sum = 0.0;
    double hottest = 0.0;
    for (int k = 0; k < subject.profile; ++k) {
        const double x = (k + 0.5) / subject.profile * half;
        truth.profile.push_back(exact.height(x));
        sum += exact.height(x);
        hottest = std::max(hottest, exact.surface_temperature(x));
    }
    for (double& height : truth.profile) height -= sum / subject.profile;
    truth.values[quantity::max_temperature] = hottest;
    return truth;
}

const reports::Measurement& found_by(const std::string& knob, const Subject& subject,
                                     const std::vector<Point>& points) {
    for (const Point& point : points) {
        if (point.trial.subject != subject.name || point.trial.knob != knob) continue;
        if (!point.record.found)
            throw NumericalFailure(subject.name + ", " + knob + ": " + point.record.ending.message);
        return *point.record.found;
    }
    throw std::logic_error("no trial is the " + knob + " of " + subject.name);
}

Truth of_finest_run(const Subject& subject, const std::vector<Point>& points) {
    const reports::Measurement& finest = found_by("truth", subject, points);
    Truth truth{
        .source = "a run beyond all others", .values = {}, .uncertainty = {}, .profile = {}};
    for (const auto& [name, amount] : finest.values()) truth.values[name] = amount.value;
    if (const auto profile = finest.sample_of(quantity::profile)) truth.profile = profile->values;
    truth.uncertainty = errors_of(found_by("check of the truth", subject, points), truth);
    return truth;
}

}  // namespace

Truth truth_of(const Subject& subject, const std::vector<Point>& points) {
    if (subject.name == "slab") return of_slab();
    if (subject.name == "sandwich, rigid") return of_free_boundary(subject);
    return of_finest_run(subject, points);
}

std::map<std::string, double> errors_of(const reports::Measurement& found, const Truth& truth) {
    std::map<std::string, double> errors;
    for (const auto& [name, exact] : truth.values)
        if (const auto value = found.value_of(name)) errors[name] = std::abs(*value / exact - 1.0);
    const auto profile = found.sample_of(quantity::profile);
    if (!profile || truth.profile.empty()) return errors;
    double sum = 0.0;
    for (size_t k = 0; k < truth.profile.size(); ++k)
        sum += std::pow(profile->values[k] - truth.profile[k], 2);
    errors[quantity::profile] = std::sqrt(sum / double(truth.profile.size())) / um;
    return errors;
}

}  // namespace crawford::tradeoff
