#include "cases/verify/stress/carried_stress.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace crawford {

namespace {

using reference::CarriedProfile;
using reference::ProfileShape;

CarriedProfile with_phase(ProfileShape shape, double phase) {
    shape.phase = phase;
    return CarriedProfile(shape);
}

/// In which nothing crosses more than a tenth of the smallest cell.
double short_step(const PrescribedMotion& body) {
    double fastest = 0.0;
    for (const Vector& v : body.velocity().values()) fastest = std::max(fastest, v.norm());
    for (const double v : body.motion().surface_rate) fastest = std::max(fastest, std::abs(v));
    const Grid& grid = body.grid();
    return 0.1 * std::min(grid.dx(), grid.height(grid.rows() - 1)) / (2.0 * fastest);
}

}  // namespace

CarriedStress::CarriedStress(const ProfileShape& shape)
    : s11_(with_phase(shape, 0.0)),
      s22_(with_phase(shape, std::numbers::pi)),
      s12_(with_phase(shape, shape.period > 0.0 ? 0.5 * std::numbers::pi : 0.0)),
      pressure_(with_phase(shape, 0.0)) {}

Deviator CarriedStress::deviator(const Vector& x) const {
    return {s11_.value(x), s22_.value(x), s12_.value(x)};
}

Deviator CarriedStress::deviator_rate(const Vector& x, const Vector& material,
                                      const Vector& point) const {
    return {s11_.rate(x, material, point), s22_.rate(x, material, point),
            s12_.rate(x, material, point)};
}

double CarriedStress::pressure_rate(const Vector& x, const Vector& material,
                                    const Vector& point) const {
    return pressure_.rate(x, material, point);
}

StressField CarriedStress::on(const PrescribedMotion& body) const {
    StressField stress = body.no_stress();
    for (const CellPoint& at : body.stress_points())
        stress.deviator[size_t(at.point)](at.i, at.j) = deviator(at.x);
    for (const CellPoint& at : body.centres()) stress.pressure(at.i, at.j) = pressure(at.x);
    return stress;
}

StressRates::StressRates(const PrescribedMotion& body, const CarriedStress& truth,
                         const Motion& motion)
    : body_(body),
      truth_(truth),
      material_(motion.velocity),
      dt_(short_step(body)),
      before_(truth.on(body)),
      after_(before_) {
    body_.stress_step().predict(after_, body_.motion(), {}, 0.0, dt_);
}

Deviator StressRates::found(const CellPoint& at) const {
    const auto k = size_t(at.point);
    return (1.0 / dt_) * (after_.deviator[k](at.i, at.j) - before_.deviator[k](at.i, at.j));
}

Deviator StressRates::exact(const CellPoint& at) const {
    const Vector material = material_ ? material_(at.x) : Vector(0.0, 0.0);
    return truth_.deviator_rate(at.x, material, {0.0, at.surface_rate});
}

Comparison StressRates::at_points() const {
    Comparison result;
    for (const CellPoint& at : body_.stress_points())
        if (is_compared(at)) result.add(found(at), exact(at), at.weight);
    return result;
}

Comparison StressRates::mean_of_cells() const {
    Comparison result;
    const int points = before_.points();
    Deviator mean_found, mean_exact;
    for (const CellPoint& at : body_.stress_points()) {
        if (!is_compared(at)) continue;
        if (at.point == 0) mean_found = mean_exact = {};
        mean_found = mean_found + (1.0 / points) * found(at);
        mean_exact = mean_exact + (1.0 / points) * exact(at);
        if (at.point == points - 1) result.add(mean_found, mean_exact, points * at.weight);
    }
    return result;
}

Comparison StressRates::pressure() const {
    Comparison result;
    for (const CellPoint& at : body_.centres()) {
        if (!is_compared(at)) continue;
        const Vector material = material_ ? material_(at.x) : Vector(0.0, 0.0);
        const double change = after_.pressure(at.i, at.j) - before_.pressure(at.i, at.j);
        result.add(change / dt_, truth_.pressure_rate(at.x, material, {0.0, at.surface_rate}),
                   at.weight);
    }
    return result;
}

double StressRates::fastest_in_first_row() const {
    double fastest = 0.0;
    for (const CellPoint& at : body_.stress_points())
        if (!is_compared(at)) fastest = std::max(fastest, std::abs(found(at).s11));
    return fastest;
}

reports::Measurement measure_rates(const CarriedSetup& setup, int cells) {
    const PrescribedMotion body(setup.domain(cells), setup.motion, setup.element);
    const CarriedStress truth(setup.profile);
    const StressRates rates(body, truth, setup.motion);
    reports::Measurement result(1.0 / cells);
    rates.at_points().report(carried::points, result);
    rates.mean_of_cells().report(carried::mean, result);
    rates.pressure().report(carried::pressure, result);
    return result.value(carried::first_row, rates.fastest_in_first_row());
}

}  // namespace crawford
