#include "solver/step/simulation.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "solver/burning/flux_modulation.hpp"
#include "solver/burning/front_motion.hpp"
#include "solver/heat/heat_step.hpp"
#include "solver/projection/projection.hpp"
#include "solver/reference_map/reference_map.hpp"
#include "solver/scene/defaults.hpp"
#include "solver/stress/stress_step.hpp"

namespace crawford {

namespace {

void check_finite(const NodeVectors& field, const char* module, const char* name) {
    for (int i = 0; i < field.columns(); ++i)
        for (int j = 0; j < field.rows(); ++j)
            if (!field(i, j).allFinite())
                throw NumericalFailure({.kind = FailureFields::Kind::not_finite,
                                        .module = module,
                                        .quantity = name,
                                        .place = FailurePlace{"node", i, j}});
}

void check_finite(const StressField& stress) {
    for (int i = 0; i < stress.pressure.columns(); ++i)
        for (int j = 0; j < stress.pressure.rows(); ++j) {
            const PlaneStress mean = stress.mean(i, j);
            if (!std::isfinite(mean.s11 + mean.s22 + mean.s33 + mean.s12))
                throw NumericalFailure({.kind = FailureFields::Kind::not_finite,
                                        .module = "stress",
                                        .quantity = "the stress",
                                        .place = FailurePlace{"cell", i, j}});
        }
}

/// What clustered columns are clustered about: the sides of the strip.
double interface_of(const Scene& scene) {
    const auto* sandwich = std::get_if<Sandwich>(&scene.morphology.shape);
    return sandwich ? 0.5 * sandwich->strip : 0.0;
}

}  // namespace

struct Simulation::Modules {
    Scene scene;
    Sources sources;
    Grid grid;
    MaterialMap materials;
    BurningLaw law;
    std::unique_ptr<FrontMotion> front;
    Checkerboard checkerboard;
    std::unique_ptr<HeatStep> heat;
    std::unique_ptr<StressStep> stress;
    std::unique_ptr<Projection> projection;
    State state;
    Stopwatch stopwatch;
    int solver_iterations = 0;
    double regression_rate = 0.0;    ///< of the last step [m/s]
    CellField shear_modulus_before;  ///< of the last step, where the morphology moves

    Modules(Scene s, Sources given)
        : scene(std::move(s)),
          sources(std::move(given)),
          grid(scene.domain, interface_of(scene)),
          materials(scene.morphology, grid, scene.numerics),
          law(scene.physics.regression, scene.surface),
          front(front_motion(scene.numerics.front, grid, materials, law)),
          checkerboard(grid, materials, scene.numerics.element),
          state(initial_state(scene, grid)) {
        if (scene.surface.ripple) materials.follow(state.surface, state.reference_shift);
        if (scene.physics.heat)
            heat = std::make_unique<HeatStep>(scene, grid, materials, law, sources);
        if (!scene.physics.mechanics) return;
        stress = std::make_unique<StressStep>(scene, grid, materials, checkerboard, sources);
        projection = std::make_unique<Projection>(scene, grid, materials, checkerboard, sources);
    }

    /// phi_t of a surface whose nodes have this temperature and velocity.
    SurfaceField surface_rate_of(const SurfaceField& surface, const NodeField& temperature,
                                 const NodeVectors& velocity, double length) const {
        const bool carried = scene.numerics.surface_motion == SurfaceMotion::burning_with_material;
        std::vector<Vector> of_material;
        if (carried && !velocity.empty())
            for (int i = 0; i < grid.node_columns(); ++i)
                of_material.push_back(velocity(i, grid.rows()));
        return front->rate({surface, temperature, of_material}, length);
    }

    /// The state one step of `length` after `now`, at the time `end`.
    State advanced(const State& now, double end, double length) {
        State next;
        if (now.previous) {
            const double ratio = length / now.length;
            const TwoStepWeights w = bdf2_weights(ratio);
            next = combination(w.of_now, now, -w.of_before, *now.previous);
            advance(next, combination(1.0 + ratio, now, -ratio, *now.previous),
                    bdf2_step(now.time, length, ratio), length);
        } else {
            next = now;
            advance(next, now, euler_step(now.time, length), length);
        }
        next.step = now.step + 1;
        next.time = end;
        next.length = length;
        return next;
    }

    /// One step. `next` enters as the base of the step; `now` is the explicit state.
    void advance(State& next, const State& now, TimeStep step, double length) {
        if (heat) {
            step.implicit_heat = std::max(step.implicit_heat, heat->least_implicit(step.span));
            move_heat(next, now, step, length);
        }
        const SurfaceField base = next.surface;
        move_surface(next, now, step, length);
        if (stress) move_solid(next, now, base, step);
    }

    void move_heat(State& next, const State& now, const TimeStep& step, double length) {
        if (scene.surface.modulation)
            law = {scene.physics.regression, heated_at(scene.surface, step.heat_time())};
        const SurfaceField rate =
            surface_rate_of(now.surface, now.temperature, now.velocity, length);
        const HeatMotion motion{{now.surface, rate, now.velocity}, now.temperature_rate};
        stopwatch.measure("heat", [&] {
            const NodeField base = next.temperature;
            heat->advance(next.temperature, now.temperature, motion, step);
            if (!next.temperature_rate.empty())
                material_rate(grid, base, next.temperature, motion, step.span,
                              next.temperature_rate);
        });
    }

    /// phi' = phi + dt phi_t, with the burn rate of the new temperature (paper sec. 3.5).
    void move_surface(State& next, const State& now, const TimeStep& step, double length) {
        stopwatch.measure("burning", [&] {
            const SurfaceField rate =
                surface_rate_of(now.surface, next.temperature, now.velocity, length);
            for (size_t i = 0; i < rate.size(); ++i) {
                next.surface[i] += step.span * rate[i];
                if (!std::isfinite(next.surface[i]))
                    throw NumericalFailure({.kind = FailureFields::Kind::not_finite,
                                            .module = "burning",
                                            .quantity = "the surface",
                                            .place = FailurePlace{"node column", int(i)}});
            }
        });
    }

    void move_solid(State& next, const State& now, const SurfaceField& base, const TimeStep& step) {
        SurfaceField rate(base.size());
        for (size_t i = 0; i < rate.size(); ++i) rate[i] = (next.surface[i] - base[i]) / step.span;
        const SolidMotion old_motion{now.surface, rate, now.velocity};

        stopwatch.measure("stress", [&] {
            stress->predict(next.stress, now.stress, old_motion, next.temperature_rate, step);
        });
        // What the map carries must be where the projection's grid is: the map takes the explicit
        // velocity then, and not that of the projection.
        const bool map_first = scene.morphology.indicator == Indicator::reference_map;
        if (map_first) move_map(next, now, rate, now.velocity, step);
        if (materials.moves()) stopwatch.measure("morphology", [&] { follow_material(next); });
        stopwatch.measure("projection", [&] {
            solver_iterations =
                projection->solve(next.stress, next.surface, step.end, step.span, next.velocity);
            check_finite(next.velocity, "projection", "velocity");
        });
        stopwatch.measure("stress", [&] {
            stress->correct(next.stress, next.surface, next.velocity, step.span);
            check_finite(next.stress);
        });
        if (!map_first) move_map(next, now, rate, next.velocity, step);
    }

    void move_map(State& next, const State& now, const SurfaceField& rate,
                  const NodeVectors& velocity, const TimeStep& step) {
        if (next.reference_shift.empty()) return;
        stopwatch.measure("reference map", [&] {
            const SolidMotion motion{now.surface, rate, velocity};
            advance_reference_map(grid, motion, step.span, now.reference_shift,
                                  next.reference_shift);
            check_finite(next.reference_shift, "reference map", "the map");
        });
    }

    /// The grid has moved through the morphology, or the morphology with the solid: cells that
    /// became softer cannot hold what they held.
    void follow_material(State& next) {
        shear_modulus_before = materials.shear_modulus();
        materials.follow(next.surface, next.reference_shift);
        stress->soften(next.stress, shear_modulus_before);
    }

    /// Keeps `now` for the next step to look back at, as soft as the material has become since.
    std::shared_ptr<const State> remembered(State now) const {
        if (scene.time.scheme == Stepping::euler) return nullptr;
        now.previous.reset();
        if (stress && materials.moves()) stress->soften(now.stress, shear_modulus_before);
        return std::make_shared<const State>(std::move(now));
    }
};

Simulation::Simulation(Scene scene, Sources sources)
    : modules_(std::make_unique<Modules>(resolved(std::move(scene)), std::move(sources))) {}

Simulation::~Simulation() = default;

void Simulation::step(double end, double length) {
    State next;
    try {
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
    const bool looks_back = modules_->scene.time.scheme == Stepping::bdf2;
    const bool fits = same_shape(state, modules_->state) &&
                      (!state.previous || (looks_back && same_shape(*state.previous, state)));
    if (!fits) throw InputError("checkpoint: its fields are not those of the scene");
    if (state.previous && state.length == 0.0) state.length = modules_->scene.time.step;
    modules_->materials.follow(state.surface, state.reference_shift);
    modules_->state = std::move(state);
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
    if (modules_->projection)
        summary.residual = modules_->projection->residual(s.stress, s.velocity, s.surface, s.time);
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
    const Grid& grid = modules_->grid;
    NodeField sum(grid.node_columns(), grid.rows() + 1);
    NodeField cells(grid.node_columns(), grid.rows() + 1);
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j)
            for (const Node& node : corners(grid, i, j)) {
                sum(node.i, node.j) += 2.0 * modules_->materials.fraction()(i, j) - 1.0;
                cells(node.i, node.j) += 1.0;
            }
    for (size_t k = 0; k < sum.values().size(); ++k) sum.values()[k] /= cells.values()[k];
    return sum;
}

SurfaceField Simulation::burn_rate() const {
    return modules_->front->burn_rate(modules_->state.temperature);
}

Lattice<Eigen::Matrix2d> Simulation::deformation_gradient() const {
    const State& s = modules_->state;
    if (s.reference_shift.empty()) return {};
    return crawford::deformation_gradient(modules_->grid, s.surface, s.reference_shift);
}

Lattice<std::array<double, 3>> Simulation::strain() const {
    const auto f = deformation_gradient();
    Lattice<std::array<double, 3>> result(f.columns(), f.rows());
    for (size_t k = 0; k < f.values().size(); ++k) {
        const Eigen::Matrix2d e = green_strain(f.values()[k]);
        result.values()[k] = {e(0, 0), e(1, 1), e(0, 1)};
    }
    return result;
}

CellField Simulation::strain_norm() const {
    const auto e = strain();
    CellField result(e.columns(), e.rows());
    const bool frobenius = modules_->scene.numerics.strain_norm == StrainNorm::frobenius;
    for (size_t k = 0; k < e.values().size(); ++k) {
        const auto& [e11, e22, e12] = e.values()[k];
        result.values()[k] = frobenius ? std::sqrt(e11 * e11 + e22 * e22 + 2.0 * e12 * e12)
                                       : std::max({std::abs(e11), std::abs(e22), std::abs(e12)});
    }
    return result;
}

}  // namespace crawford
