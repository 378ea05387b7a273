#include "cases/scenes/slab.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/errors.hpp"
#include "reference/material.hpp"
#include "reference/slab.hpp"
#include "solver/mesh/grid.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

constexpr double cold = 300.0;  // [K]

/// How far material goes in a step, in smallest cells. The steady state does not depend on it, but
/// forward Euler with WENO3 amplifies slowly, and must not do so before the wave has left.
constexpr double cells_a_step = 0.2;

/// Largest change from `before` to `after`, relative to the largest value.
template <class Value, class Size>
double change(const Lattice<Value>& before, const Lattice<Value>& after, Size size) {
    double difference = 0.0;
    double largest = 0.0;
    for (size_t k = 0; k < after.values().size(); ++k) {
        difference = std::max(difference, size(Value(after.values()[k] - before.values()[k])));
        largest = std::max(largest, size(after.values()[k]));
    }
    return largest > 0.0 ? difference / largest : 0.0;
}

double change(const State& before, const State& after) {
    return std::max(
        change(before.temperature, after.temperature, [](double t) { return std::abs(t); }),
        change(before.velocity, after.velocity, [](const Vector& v) { return std::abs(v.y()); }));
}

SlabProfile profile(const Simulation& simulation, const State& before) {
    const Grid& grid = simulation.grid();
    const State& state = simulation.state();
    SlabProfile p;
    p.burn_rate = (before.surface.front() - state.surface.front()) / (state.time - before.time);
    for (int j = 0; j <= grid.rows(); ++j) {
        p.node_y.push_back(grid.eta(j));
        p.node_weight.push_back(
            0.5 * ((j > 0 ? grid.height(j - 1) : 0.0) + (j < grid.rows() ? grid.height(j) : 0.0)));
        p.temperature.push_back(state.temperature(0, j));
        if (!state.velocity.empty()) p.velocity.push_back(state.velocity(0, j).y());
    }
    const auto f = simulation.deformation_gradient();
    for (int j = 0; j < grid.rows(); ++j) {
        p.cell_y.push_back(0.5 * (grid.eta(j) + grid.eta(j + 1)));
        p.cell_weight.push_back(grid.height(j));
        if (state.stress.empty()) continue;
        const PlaneStress s = state.stress.mean(0, j);
        p.stress_11.push_back(s.s11);
        p.stress_22.push_back(s.s22);
        p.pressure.push_back(state.stress.pressure(0, j));
        p.deformation_gradient_22.push_back(f(0, j)(1, 1));
    }
    return p;
}

/// Either half's material: their properties have the same names.
template <class Material>
void stiffen(Material& material, double n) {
    material.bulk_modulus *= n * n;
    material.shear_modulus *= n * n;
    material.thermal_expansion /= n;
}

}  // namespace

Slab::Slab(std::string material, Grid grid) : material_(std::move(material)), grid_(grid) {}

Slab slab(const std::string& material, Slab::Grid grid) {
    return {material, grid};
}

Slab& Slab::burning_by_law() {
    by_law_ = true;
    return *this;
}

Slab& Slab::stiffened(double n) {
    stiffening_ = n;
    return *this;
}

Slab& Slab::regressing(double burn_rate) {
    burn_rate_ = burn_rate;
    return *this;
}

Slab& Slab::heated(double flux) {
    flux_ = flux;
    return *this;
}

Slab& Slab::pressed(double pressure) {
    pressure_ = pressure;
    return *this;
}

Slab& Slab::thermal_stress_alpha_k() {
    alpha_k_ = true;
    return *this;
}

Slab& Slab::rigid() {
    rigid_ = true;
    return *this;
}

Scene Slab::scene() const {
    Material material = material_ == "AP" ? ammonium_perchlorate() : htpb_binder();
    if (!by_law_) material.heat_of_reaction = 0.0;
    stiffen(material, stiffening_);
    const auto reading = alpha_k_ ? ThermalStress::alpha_bulk : ThermalStress::three_alpha_bulk;

    Scene scene;
    scene.title = material_ + " slab";
    scene.domain = {.width = 5e-6,
                    .depth = grid_.depth,
                    .nx = 1,
                    .ny = grid_.cells,
                    .clustering = grid_.clustering};
    scene.morphology.materials = {material};
    scene.physics = {.mechanics = !rigid_,
                     .reference_map = !rigid_,
                     .regression = by_law_ ? Regression::pyrolysis : Regression::fixed};
    scene.surface = {.pressure = pressure_, .heat_flux = {flux_}, .burn_rate = burn_rate_};
    scene.bottom.temperature = cold;
    scene.numerics.thermal_stress = reading;
    scene.numerics.stress_work = reading;
    const double smallest = grid_.depth / grid_.cells * std::pow(2.0, -grid_.clustering);
    const auto model = rigid_ ? reference::SlabModel::thermal : reference::SlabModel::eulerian;
    const double rate = by_law_ ? reference::Slab(conditions(model)).burn_rate() : burn_rate_;
    scene.time.step = cells_a_step * smallest / rate;
    scene.time.end = 3.0;
    return scene;
}

reference::SlabConditions Slab::conditions(reference::SlabModel model) const {
    auto material = material_ == "AP" ? reference::ap() : reference::binder();
    stiffen(material, stiffening_);
    return {.material = by_law_ ? material : reference::without_reaction(material),
            .model = model,
            .thermal_stress = alpha_k_ ? reference::ThermalStress::alpha_k
                                       : reference::ThermalStress::three_alpha_k,
            .regression =
                by_law_ ? reference::Regression::pyrolysis : reference::Regression::prescribed,
            .heat_flux = flux_,
            .burn_rate = burn_rate_,
            .pressure = pressure_,
            .cold_temperature = cold,
            .depth = grid_.depth};
}

SlabProfile burn_to_steady(const Scene& scene, double tolerance) {
    Simulation simulation(scene);
    State before = simulation.state(), now = before;
    double changed = std::numeric_limits<double>::infinity();
    const auto steps = steps_of(simulation);
    const Stop ended = [&](const Simulation& burning) {
        return changed <= tolerance || steps->at_the_end(burning.state());
    };
    const Observer compare = [&](const Simulation& burning, double) {
        before = std::exchange(now, burning.state());
        changed = change(before, now);
    };
    run_until(simulation, *steps, ended, {compare});
    if (changed <= tolerance) return profile(simulation, before);
    throw NumericalFailure(
        fmt::format("{}: not steady after {} s: the last step changed a value by {:.3g} of the "
                    "largest, limit {:.3g}",
                    scene.title, scene.time.end, changed, tolerance));
}

}  // namespace crawford
