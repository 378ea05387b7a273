/// # Rotation: does stress turn with the body, by the right angle and the right way?
///
/// Under the Jaumann rate a body that turns without being strained takes its stress along: the
/// principal stresses stay, their axes turn. And a body sheared from rest answers with
/// tau = mu sin(gamma), sigma_11 - sigma_22 = 2 mu (1 - cos(gamma)) (Dienes 1979), because the spin
/// of a shear turns what the strain has built up. Both are exact (reference/exact_motions.hpp); a
/// wrong sign or factor of either half of the spin is an error of the size of the stress.
///
/// In space: one step of a body whose stress also varies from place to place, on a level uniform
/// grid. Advection and rotation only add up to the truth together. WENO3 carries, so three in L1
/// less a logarithm for a strong stress (cases/verify/stress/advection.cpp explains); the velocity
/// is linear in space, which bilinear cells hold exactly.
///
/// In time: a uniform stress needs no advection, so one mirrored column of cells, sloped and
/// clustered, turns through a radian without any error in space. `predict` is a forward Euler step:
/// order one. Turning multiplies (s11 - s22)/2 + i s12 by 1 + 2 i omega dt, the length of which is
/// not one: the principal difference grows by 2 (omega dt)^2 a step, 2 theta^2/n over n steps, and
/// that constant is gated too.

#include <algorithm>
#include <cmath>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/comparison.hpp"
#include "cases/verify/prescribed_motion.hpp"
#include "reference/carried_profile.hpp"
#include "reference/exact_motions.hpp"

namespace crawford {

namespace {

using namespace units;
using Eigen::Matrix2d;
using reference::CarriedProfile;
using reference::RigidRotation;
using reports::between;
using reports::expect;
using reports::Norm;

constexpr double width = 240.0 * um;
constexpr auto growth = "n (growth of the principal difference)";
constexpr auto pressure = "largest pressure after the shear [MPa]";

/// A stress that varies in x and y, far stronger than what the solver takes for smooth.
class Stress {
public:
    Stress()
        : s11_({.amplitude = 9000.0 * MPa, .period = width}),
          s22_({.amplitude = -4000.0 * MPa,
                .period = width,
                .phase = 1.0,
                .column = reference::ColumnShape::exponential,
                .width = width}),
          s12_({.amplitude = 6000.0 * MPa,
                .column = reference::ColumnShape::bump,
                .middle = -0.6 * width,
                .width = 0.5 * width}) {}

    Matrix2d value(const Vector& x) const {
        return symmetric(s11_.value(x), s22_.value(x), s12_.value(x));
    }
    /// -v.grad(S) of a velocity v.
    Matrix2d advected(const Vector& x, const Vector& v) const {
        const Vector at_rest(0.0, 0.0);
        return symmetric(s11_.rate(x, v, at_rest), s22_.rate(x, v, at_rest),
                         s12_.rate(x, v, at_rest));
    }

private:
    static Matrix2d symmetric(double s11, double s22, double s12) {
        return (Matrix2d() << s11, s12, s12, s22).finished();
    }

    CarriedProfile s11_, s22_, s12_;
};

Deviator deviator(const Matrix2d& s) {
    return {s(0, 0), s(1, 1), s(0, 1)};
}

/// One step of a turning body, compared in its middle: a rotation is not periodic in x.
reports::Measurement turn_a_little(Element element, int cells) {
    const double turn_rate = -2.0 / s;
    const Vector centre(0.03 * width, -0.45 * width);
    const RigidRotation rotation(turn_rate, centre);
    const PrescribedMotion body(
        {.width = width, .depth = width, .nx = cells, .ny = cells, .clustering = 0.0},
        {.velocity = [&](const Vector& x) { return rotation.velocity(x); }}, element);
    const Stress truth;
    StressField stress = body.no_stress();
    const auto points = body.stress_points();
    for (const CellPoint& at : points)
        stress.deviator[size_t(at.point)](at.i, at.j) = deviator(truth.value(at.x));
    const StressField before = stress;
    const double dt = 0.1 / cells;
    body.stress_step().predict(stress, body.motion(), {}, 0.0, dt);

    Comparison rate;
    for (const CellPoint& at : points) {
        if ((at.x - Vector(0.0, -0.5 * width)).lpNorm<Eigen::Infinity>() > 0.25 * width) continue;
        const auto k = size_t(at.point);
        rate.add((1.0 / dt) * (stress.deviator[k](at.i, at.j) - before.deviator[k](at.i, at.j)),
                 deviator(truth.advected(at.x, rotation.velocity(at.x)) +
                          rotation.stress_rate(truth.value(at.x))));
    }
    return reports::Measurement(1.0 / cells).field("rate of the deviator", rate.found, rate.exact);
}

/// One column of cells between two planes of symmetry: no stencil reaches along the rows, and the
/// gradient of the velocity is exact.
Domain column() {
    return {.width = width, .depth = width, .nx = 2, .ny = 4, .clustering = 2.0, .half = true};
}

double slope(double x) {
    return 0.4 * x;
}

/// Steps of predict and correct over `duration`.
StressField evolve(const PrescribedMotion& body, StressField stress, double duration, int steps) {
    const double dt = duration / steps;
    for (int n = 0; n < steps; ++n) {
        body.stress_step().predict(stress, body.motion(), {}, n * dt, dt);
        body.stress_step().correct(stress, body.surface(), body.velocity(), dt);
    }
    return stress;
}

Comparison everywhere(const PrescribedMotion& body, const StressField& stress,
                      const Matrix2d& truth) {
    Comparison result;
    for (const CellPoint& at : body.stress_points())
        result.add(stress.deviator[size_t(at.point)](at.i, at.j), deviator(truth));
    return result;
}

double principal_difference(const Deviator& s) {
    return std::hypot(s.s11 - s.s22, 2.0 * s.s12);
}

reports::Measurement turn_a_radian(Element element, int steps) {
    const double theta = 1.0;
    const RigidRotation rotation(theta / s, {0.1 * width, -0.5 * width});
    const PrescribedMotion body(
        column(),
        {.surface = slope, .velocity = [&](const Vector& x) { return rotation.velocity(x); }},
        element);
    const Matrix2d start = (Matrix2d() << 3.0, 2.0, 2.0, -1.0).finished() * MPa;
    StressField stress = body.no_stress();
    for (auto& point : stress.deviator) std::ranges::fill(point.values(), deviator(start));
    const StressField turned = evolve(body, stress, 1.0 * s, steps);

    const auto all = everywhere(body, turned, rotation.stress(start, 1.0 * s));
    const double factor =
        principal_difference(turned.deviator.front()(0, 2)) / principal_difference(deviator(start));
    return reports::Measurement(1.0 / steps)
        .field("deviator", all.found, all.exact)
        .value(growth, steps * (factor - 1.0));
}

reports::Measurement shear(Element element, int steps) {
    const reference::SimpleShear motion(1.5 / s, -width);
    const PrescribedMotion body(
        column(),
        {.surface = slope, .velocity = [&](const Vector& x) { return motion.velocity(x); }},
        element);
    const StressField sheared = evolve(body, body.no_stress(), 1.0 * s, steps);
    const auto all = everywhere(body, sheared, motion.stress(body.shear_modulus(), 1.0 * s));
    double largest = 0.0;
    for (const double p : sheared.pressure.values()) largest = std::max(largest, std::abs(p));
    return reports::Measurement(1.0 / steps)
        .field("deviator", all.found, all.exact)
        .value(pressure, largest / MPa);
}

std::vector<reports::Study> studies_of(Element element, const std::string& name) {
    reports::Study in_space("rotation, one step of a turning body, " + name);
    in_space.refines("cells", {32, 64, 128, 256})
        .measure([element](int cells) { return turn_a_little(element, cells); })
        .covers({term::jaumann_rotation, term::stress_advection})
        .gate("rate of the deviator", Norm::L1, expect(3.0).within(0.45, 0.1),
              "WENO3 carries: h^3 log(1/h) beside inflections; rotation adds no error");

    reports::Study in_time("rotation, by a radian, " + name);
    in_time.refines("steps", {16, 32, 64, 128})
        .measure([element](int steps) { return turn_a_radian(element, steps); })
        .covers({term::jaumann_rotation, term::slope, term::time_step})
        .gate("deviator", Norm::L2, expect(1.0).within(0.1), "forward Euler, no error in space")
        .limit_bound(growth, 1.0, between(1.98, 2.02),
                     "|1 + 2 i omega dt|^n = 1 + 2 theta^2/n + O(1/n^2), theta = 1; 1 %");

    reports::Study sheared("rotation, simple shear, " + name);
    sheared.refines("steps", {16, 32, 64, 128})
        .measure([element](int steps) { return shear(element, steps); })
        .covers({term::jaumann_rotation, term::elasticity, term::slope, term::time_step})
        .gate("deviator", Norm::L2, expect(1.0).within(0.1), "forward Euler, no error in space")
        .bound(pressure, 128, between(-1e-6, 1e-6),
               "a shear has no divergence; round-off of K div v, K = 15 GPa");
    return {in_space, in_time, sheared};
}

std::vector<reports::Study> studies() {
    auto all = studies_of(Element::bbar, "bbar");
    std::ranges::copy(studies_of(Element::q1, "q1"), std::back_inserter(all));
    return all;
}

const Registered here{{.name = "rotation",
                       .figure = "-",
                       .shows = "stress of a turning and of a sheared body",
                       .cost = {.verify = 1.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
