#include "solver/stress/stress_step.hpp"

#include <cmath>

#include "base/errors.hpp"

namespace crawford {

StressStep::StressStep(const Scene& scene, const Grid& grid, const MaterialMap& materials,
                       const Checkerboard& checkerboard, const StressSources& sources)
    : grid_(grid),
      materials_(materials),
      checkerboard_(checkerboard),
      neighbours_(grid, materials),
      source_(sources.stress),
      element_(scene.numerics.element),
      thermal_stress_(scene.numerics.thermal_stress),
      in_turns_(scene.time.mechanics_every > 1) {}

void StressStep::predict(StressField& stress, const StressField& carried, const SolidMotion& motion,
                         const CellField& temperature_rate, const TimeStep& step) const {
    const double dt = step.span;
    StressField next = stress;
    for (int i = 0; i < grid_.cell_columns(); ++i)
        for (int j = 0; j < grid_.rows(); ++j) {
            const Carried here = carried_at(i, j, motion);
            for (int k = 0; k < stress.points(); ++k) {
                Deviator& s = next.deviator[size_t(k)](i, j);
                s = s + dt * deviator_rate(carried, k, here, dt);
            }
            double& p = next.pressure(i, j);
            p += dt * pressure_rate(carried.pressure, here);
            if (!temperature_rate.empty())
                p += dt * materials_.thermal_stress(i, j, thermal_stress_) * temperature_rate(i, j);
        }
    if (source_) add_source(next, motion.surface, step.explicit_time, dt);
    stress = std::move(next);
}

StressStep::Carried StressStep::carried_at(int i, int j, const SolidMotion& motion) const {
    const auto nodes = corners(grid_, i, j);
    Carried here{.i = i,
                 .j = j,
                 .cell = Cell(grid_, motion.surface, i, j),
                 .velocity = gather(motion.velocity, nodes),
                 .relative = {},
                 .row = neighbours_.along_row(i, j),
                 .column = neighbours_.along_column(i, j)};
    for (size_t k = 0; k < 4; ++k) here.relative[k] = relative_velocity(motion, nodes[k]);
    return here;
}

/// Velocity across the grid in cells per second:
/// (u/(dx/di), vbar/(d eta/dj)), vbar = v - phi_t - u phi_x.
Vector StressStep::grid_velocity(const Carried& here, Local at) const {
    const int j = here.j;
    const Vector w = interpolate(here.relative, at);
    const double metric = (1.0 - at.b) * grid_.metric(j) + at.b * grid_.metric(j + 1);
    return {w.x() / grid_.metric_x(here.i, at.a), (w.y() - w.x() * here.cell.slope) / metric};
}

Deviator StressStep::deviator_rate(const StressField& stress, int point, const Carried& here,
                                   double dt) const {
    const Local at = stress_points(element_)[size_t(point)];
    const Vector w = grid_velocity(here, at);
    if (!(std::abs(w.x()) * dt <= 1.0 && std::abs(w.y()) * dt <= 1.0))
        throw NumericalFailure(
            {.kind = FailureFields::Kind::beyond_limit,
             .module = "stress",
             .quantity = "cells that the material crosses in one step",
             .value = dt * w.cwiseAbs().maxCoeff(),
             .limit = FailureLimit{.value = 1.0},
             .place = FailurePlace{"cell", here.i, here.j},
             .advice = in_turns_ ? "reduce time.mechanics_every" : "reduce time.step"});

    Deviator rate = -w.y() * upwind_derivative(stress, point, here.column, w.y());
    if (grid_.cell_columns() > 1)
        rate = rate - w.x() * upwind_derivative(stress, point, here.row, w.x());

    // Jaumann rotation (paper eq. 39); sigma11 - sigma22 = s11 - s22.
    const Eigen::Matrix2d grad_v = gradient(here.cell, here.velocity, at);
    const double omega = 0.5 * (grad_v(1, 0) - grad_v(0, 1));
    const Deviator& s = stress.deviator[size_t(point)](here.i, here.j);
    return rate + omega * Deviator{-2.0 * s.s12, 2.0 * s.s12, s.s11 - s.s22};
}

double StressStep::pressure_rate(const CellField& pressure, const Carried& here) const {
    const Vector w = grid_velocity(here, cell_centre);
    double rate = -w.y() * upwind_derivative(pressure, here.column, w.y());
    if (grid_.cell_columns() > 1) rate -= w.x() * upwind_derivative(pressure, here.row, w.x());
    return rate;
}

void StressStep::add_source(StressField& stress, const SurfaceField& surface, double time,
                            double dt) const {
    const auto& points = stress_points(element_);
    for (int i = 0; i < grid_.cell_columns(); ++i)
        for (int j = 0; j < grid_.rows(); ++j)
            for (size_t k = 0; k < points.size(); ++k) {
                const Local at = points[k];
                const double x = grid_.x(i) + at.a * grid_.dx(i);
                const double phi =
                    surface[size_t(i)] + at.a * grid_.dx(i) * grid_.slope(surface, i);
                const double eta = grid_.eta(j) + at.b * grid_.height(j);
                const PlaneStress s = source_(x, phi + eta, time);
                const double mean = (s.s11 + s.s22 + s.s33) / 3.0;
                Deviator& deviator = stress.deviator[k](i, j);
                deviator = deviator + dt * Deviator{s.s11 - mean, s.s22 - mean, s.s12};
                stress.pressure(i, j) -= dt * mean / double(points.size());
            }
}

void StressStep::correct(StressField& stress, const SurfaceField& surface,
                         const NodeVectors& velocity, double dt) const {
    const auto& points = stress_points(element_);
    for (int i = 0; i < grid_.cell_columns(); ++i)
        for (int j = 0; j < grid_.rows(); ++j) {
            const Cell cell(grid_, surface, i, j);
            const auto v = gather(velocity, corners(grid_, i, j));
            const double twice_mu = 2.0 * materials_.shear_modulus(i, j);
            for (size_t k = 0; k < points.size(); ++k) {
                const Eigen::Matrix2d g = gradient(cell, v, points[k]);
                const double third = g.trace() / 3.0;
                Deviator& s = stress.deviator[k](i, j);
                s = s + dt * twice_mu *
                            Deviator{g(0, 0) - third, g(1, 1) - third, 0.5 * (g(0, 1) + g(1, 0))};
            }
            stress.pressure(i, j) -=
                dt * materials_.bulk_modulus(i, j) * gradient(cell, v, cell_centre).trace();
        }
    checkerboard_.remove_from(stress.pressure);
}

void StressStep::soften(StressField& stress, const CellField& before) const {
    for (int i = 0; i < grid_.cell_columns(); ++i)
        for (int j = 0; j < grid_.rows(); ++j) {
            const double ratio = materials_.shear_modulus(i, j) / before(i, j);
            if (ratio >= 1.0) continue;
            for (auto& point : stress.deviator) point(i, j) = ratio * point(i, j);
        }
}

}  // namespace crawford
