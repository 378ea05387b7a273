/// # Reference map: is every particle remembered where it started?
///
/// Motions whose particles can be followed in closed form (reference/exact_motions.hpp): a rigid
/// rotation, a simple shear, a wavy shear that is curved in x, a uniaxial flow that is curved in y.
/// On a level uniform grid the first two are linear in space and hide every error of second order;
/// so all of them run on a clustered grid under a curved surface that moves.
///
/// - One step of `advance_reference_map` from the exact shift xi - x: (after - before)/dt is the
///   rate that the discretisation gives, without any error in time. ENO2 takes the flatter of two
///   second-order stencils: two in Linf as well as L1, also beside the surface and the bottom,
///   where one of the rows that it reads is extrapolated.
/// - Evolved in time. A turning body in steps of Euler on a grid that holds it exactly: order one,
///   and E, which should stay zero, becomes -theta^2/(2 n) I. Read where neither the held bottom
///   nor the sides have reached: two nodes a step. The uniaxial flow, which leaves the bottom
///   alone, from the first moment on, with dt ~ h^2: two.

#include "solver/reference_map/reference_map.hpp"

#include <Eigen/LU>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/comparison.hpp"
#include "cases/verify/reference_map/followed_motion.hpp"
#include "reference/exact_motions.hpp"

namespace crawford {

namespace {

using namespace units;
using namespace wavy_square;
using Eigen::Matrix2d;
using reports::between;
using reports::expect;
using reports::Norm;

constexpr auto rate = "rate of xi - x";
constexpr auto drift_11 = "n E_11/theta^2";
constexpr auto drift_12 = "n E_12/theta^2";

/// d(shift)/dt at a point that rides with the grid: xi_t + phi_t (d(xi)/dy - e_y), xi_t = -v(xi).
Vector exact_rate(const FollowedMotion& motion, const Vector& x) {
    const Matrix2d gradient_of_origin = motion.gradient(x).inverse();
    return -motion.velocity(motion.origin(x)) +
           surface_rate(x.x()) * (gradient_of_origin.col(1) - Vector::UnitY());
}

reports::Measurement one_step(const FollowedMotion& motion, int cells) {
    const PrescribedMotion exact = body(motion, cells);
    const Grid& grid = exact.grid();
    const NodeVectors before = shift_of(exact, motion);
    NodeVectors after = before;
    const double dt = 1e-3 * width / burn_rate / cells;
    advance_reference_map(grid, exact.motion(), dt, after);

    Comparison rates;
    for (int i = 0; i < grid.node_columns(); ++i)
        for (int j = 1; j <= grid.rows(); ++j) {
            const Vector x = exact.node(i, j);
            if (!is_inside(x)) continue;
            const Vector found = (after(i, j) - before(i, j)) / dt;
            rates.add(found, exact_rate(motion, x), grid.metric(j));
        }
    reports::Measurement result(1.0 / cells);
    rates.report(rate, result);
    return result;
}

/// A body that turns by theta, compared in the few cells that neither the bottom nor the sides have
/// reached in the largest number of steps.
reports::Measurement turn(int steps) {
    constexpr double theta = 0.1;
    constexpr int most_steps = 32;
    constexpr int core = 4;
    constexpr int cells = 2 * (2 * most_steps + core);
    const reference::RigidRotation rotation(theta / s, {0.0, -0.5 * width});
    const FollowedMotion truth = followed(rotation, 1.0 * s);
    const PrescribedMotion body(
        {.width = width, .depth = width, .nx = cells, .ny = cells, .clustering = 0.0},
        {.velocity = truth.velocity});
    NodeVectors shift(cells, cells + 1);
    for (int n = 0; n < steps; ++n)
        advance_reference_map(body.grid(), body.motion(), 1.0 * s / steps, shift);

    const auto found = deformation_gradient(body.grid(), body.surface(), shift);
    Comparison shifts, f;
    for (int i = cells / 2 - core; i < cells / 2 + core; ++i)
        for (int j = cells / 2 - core; j < cells / 2 + core; ++j) {
            const Vector x = body.node(i, j);
            shifts.add(shift(i, j), truth.origin(x) - x);
            f.add(found(i, j), truth.gradient(x));
        }
    const Matrix2d strain = green_strain(found(cells / 2, cells / 2)) * steps / (theta * theta);
    reports::Measurement result(1.0 / steps);
    shifts.report("xi - x", result);
    f.report("F", result);
    return result.value(drift_11, strain(0, 0)).value(drift_12, strain(0, 1));
}

/// A column that stretches for as long as its material needs to rise by a quarter of its depth.
reports::Measurement stretch(int cells) {
    const double end = 0.5 * width / burn_rate;
    const FollowedMotion truth =
        followed(reference::UniaxialFlow(0.5 * burn_rate, -width, width), end);
    const PrescribedMotion body(
        {.width = width, .depth = width, .nx = 1, .ny = cells, .clustering = 1.0},
        {.velocity = truth.velocity});
    const int steps = cells * cells / 8;
    NodeVectors shift(1, cells + 1);
    for (int n = 0; n < steps; ++n)
        advance_reference_map(body.grid(), body.motion(), end / steps, shift);

    Comparison shifts;
    for (int j = 1; j <= cells; ++j) {
        const Vector x = body.node(0, j);
        shifts.add(shift(0, j), truth.origin(x) - x, body.grid().metric(j));
    }
    reports::Measurement result(1.0 / cells);
    shifts.report("xi - x", result);
    report_gradients(body, shift, truth, result);
    return result;
}

reports::Study step_study(const std::string& name, const FollowedMotion& motion) {
    reports::Study study("reference-map, one step, " + name);
    study.refines("cells", {32, 64, 128, 256})
        .measure([motion](int cells) { return one_step(motion, cells); })
        .covers({term::map_advection, term::slope, term::clustering, term::grid_motion})
        .gate(rate, Norm::L1, expect(2.0).within(0.1), "ENO2")
        .gate(rate, Norm::Linf, expect(2.0).within(0.2, 0.1).from(64),
              "ENO2 in every row; at the bottom clustering nears its two from below");
    return study;
}

reports::Study turning() {
    reports::Study study("reference-map, turned in n steps");
    study.refines("steps", {4, 8, 16, 32})
        .measure(turn)
        .covers({term::map_advection, term::deformation, term::time_step})
        .gate("xi - x", Norm::L2, expect(1.0).within(0.05), "Euler; a linear map is exact in space")
        .gate("F", Norm::L2, expect(1.0).within(0.05), "the same")
        .limit_bound(
            drift_11, 1.0, between(-0.505, -0.495),
            "each step scales grad(xi) by sqrt(1 + (theta/n)^2): E = -theta^2/(2 n) I; 1 %")
        .limit_bound(drift_12, 1.0, between(-1e-6, 1e-6), "the same without shear; round-off");
    return study;
}

reports::Study stretching() {
    reports::Study study("reference-map, stretched, dt ~ h^2");
    study.refines("cells", {32, 64, 128, 256})
        .measure(stretch)
        .covers({term::map_advection, term::deformation, term::clustering});
    for (const auto* quantity : {"xi - x", "F", "E"})
        study.gate(quantity, Norm::L2, expect(2.0).within(0.1), "ENO2, and Euler with dt ~ h^2");
    return study;
}

std::vector<reports::Study> studies() {
    const double t = 0.1 * width / burn_rate;
    const auto rotation =
        followed(reference::RigidRotation(0.5 / t, {0.1 * width, -0.4 * width}), t);
    const auto shear = followed(reference::SimpleShear(0.5 / t, -0.3 * width), t);
    const auto wavy = [&](double drift) {
        return followed(reference::WavyShear(drift, 0.5 * burn_rate, width), t);
    };
    const auto flow = followed(reference::UniaxialFlow(0.5 * burn_rate, -1.1 * width, width), t);
    return {step_study("rotation", rotation),
            step_study("simple shear", shear),
            step_study("wavy shear drifting right", wavy(0.7 * burn_rate)),
            step_study("wavy shear drifting left", wavy(-0.7 * burn_rate)),
            step_study("uniaxial flow", flow),
            turning(),
            stretching()};
}

const Registered here{{.name = "reference-map",
                       .figure = "-",
                       .shows = "where particles started, in exact motions",
                       .cost = {.verify = 3.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
