#include "solver/step/simulation.hpp"

#include <algorithm>

#include "base/errors.hpp"
#include "solver/reference_map/reference_map.hpp"
#include "solver/scene/defaults.hpp"
#include "solver/step/derived_fields.hpp"
#include "solver/step/modules.hpp"

namespace crawford {

Simulation::Simulation(Scene scene, Sources sources)
    : modules_(std::make_unique<Modules>(resolved(std::move(scene)), std::move(sources))) {}

Simulation::~Simulation() = default;

void Simulation::step(double end, double length) {
    State next;
    try {
        if (!modules_->loaded) modules_->load();
        next = modules_->advanced(modules_->state, end, length);
    } catch (const NumericalFailure& failure) {
        modules_->materials.follow(modules_->state.surface, modules_->state.reference_shift);
        FailureFields fields = failure.fields();
        fields.step = modules_->state.step + 1;
        fields.time = modules_->state.time + length;
        throw NumericalFailure(std::move(fields));
    }
    if (!modules_->stress && modules_->materials.moves()) modules_->materials.follow(next.surface);
    const auto height = [&](const State& state) {
        return mean_height(modules_->grid, state.surface);
    };
    modules_->regression_rate = (height(modules_->state) - height(next)) / length;
    next.previous = modules_->remembered(std::move(modules_->state));
    modules_->state = std::move(next);
}

void Simulation::restore(State state) {
    const bool between = !modules_->moves_solid_at(state.step);
    const bool looks_back = modules_->scene.time.scheme == Stepping::bdf2 || between;
    const bool fits = same_shape(state, modules_->state) && (state.previous || !between) &&
                      (!state.previous || (looks_back && same_shape(*state.previous, state)));
    if (!fits) throw InputError("checkpoint: its fields are not those of the scene");
    if (state.previous && state.length == 0.0) state.length = modules_->scene.time.step;
    modules_->materials.follow(state.surface, state.reference_shift);
    modules_->state = std::move(state);
    modules_->forget_residual();
    modules_->loaded = true;
}

StepNumbers Simulation::step_numbers() const {
    if (!modules_->heat) return {};
    return {modules_->heat->coupling(), modules_->heat->contraction()};
}

void Simulation::forget_factorisation() {
    if (modules_->projection) modules_->projection->forget();
}

const Scene& Simulation::scene() const {
    return modules_->scene;
}
const Grid& Simulation::grid() const {
    return modules_->grid;
}
const State& Simulation::state() const {
    return modules_->state;
}
std::vector<ModuleTime> Simulation::timing() const {
    return modules_->stopwatch.modules();
}

Summary Simulation::summary() const {
    const State& s = modules_->state;
    Summary summary;
    summary.mean_burn_rate = modules_->front->mean_burn_rate(s.surface, s.temperature);
    summary.regression_rate = modules_->regression_rate;
    if (!s.temperature.empty()) {
        const auto [least, largest] = std::ranges::minmax(s.temperature.values());
        summary.least_temperature = least;
        summary.largest_temperature = largest;
    }
    if (!s.reference_shift.empty())
        summary.largest_strain = *std::ranges::max_element(strain_norm().values());
    if (modules_->projection) summary.residual = modules_->residual();
    summary.solver_iterations = modules_->solver_iterations;
    return summary;
}

int Simulation::solver_iterations() const {
    return modules_->solver_iterations;
}

CellField Simulation::material_fraction() const {
    return modules_->materials.fraction();
}

NodeField Simulation::material_indicator() const {
    return indicator(modules_->grid, modules_->materials.fraction());
}

SurfaceField Simulation::burn_rate() const {
    return modules_->front->burn_rate(modules_->state.temperature);
}

Lattice<Eigen::Matrix2d> Simulation::deformation_gradient() const {
    const State& s = modules_->state;
    if (s.reference_shift.empty()) return {};
    const SurfaceField& surface = modules_->solid_of(s).surface;
    return crawford::deformation_gradient(modules_->grid, surface, s.reference_shift);
}

Lattice<std::array<double, 3>> Simulation::strain() const {
    return strains(deformation_gradient());
}

CellField Simulation::strain_norm() const {
    return norms(strain(), modules_->scene.numerics.strain_norm);
}

}  // namespace crawford
