#include "cases/verify/coupled/manufactured_burn.hpp"

#include <fmt/format.h>

#include "cases/units.hpp"
#include "reference/manufactured_burning.hpp"
#include "solver/element/element.hpp"
#include "solver/mesh/cell.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

using namespace units;
using reference::ManufacturedBurning;

constexpr double window = 240.0 * um;
constexpr double pressure = 2.0 * MPa;
constexpr double gas_flux = 8e6;  // [W/m^2]

/// Between AP and binder: K/mu = 5, and a coupling number g of 0.3 at the surface.
Material solid() {
    Material material = ammonium_perchlorate();
    material.bulk_modulus = 5e9;
    material.shear_modulus = 1e9;
    material.thermal_expansion = 1.5e-4;
    return material;
}

ManufacturedBurning truth() {
    reference::Material material = reference::ap();
    material.bulk_modulus = 5e9;
    material.shear_modulus = 1e9;
    material.thermal_expansion = 1.5e-4;
    return ManufacturedBurning({.material = material,
                                .width = window,
                                .depth = window,
                                .regression_rate = 0.45 * cm / s,
                                .wave_height = 6.0 * um,
                                .wave_frequency = 300.0,
                                .bottom_temperature = 300.0,
                                .displacement = 4.0 * um,
                                .motion_frequency = 800.0,
                                .stress = 200.0 * MPa,
                                .gas_pressure = pressure,
                                .gas_flux = gas_flux});
}

Scene scene_of(const ManufacturedBurn& burn) {
    Scene scene;
    scene.domain = {.width = window,
                    .depth = window,
                    .nx = burn.cells,
                    .ny = burn.cells,
                    .clustering = 1.0,
                    .clustering_x = burn.clustering_x};
    scene.morphology.materials = {solid()};
    scene.surface = {.pressure = pressure, .heat_flux = {gas_flux}};
    scene.bottom.support = Support::clamped;
    scene.time = {.step = burn.end / burn.steps, .end = burn.end, .scheme = burn.scheme};
    scene.numerics.element = burn.element;
    scene.numerics.coupling = burn.coupling;
    scene.numerics.solver = burn.solver;
    return scene;
}

PlaneStress plane(const reference::PlaneStrainStress& s) {
    return {s.xx, s.yy, s.zz, s.xy};
}

/// What drives a run that begins at time `start` of the truth [s].
Sources sources(const ManufacturedBurning& exact, double start) {
    Sources sources;
    sources.heat = [&exact, start](double x, double y, double t) {
        return exact.heat_source(x, y, start + t);
    };
    sources.stress = [&exact, start](double x, double y, double t) {
        return plane(exact.stress_source(x, y, start + t));
    };
    sources.body_force = [&exact, start](double x, double y, double t) {
        return exact.body_force(x, y, start + t);
    };
    sources.heat_flux = [&exact, start](double x, double, double t) {
        return exact.heat_flux(x, start + t);
    };
    sources.traction = [&exact, start](double x, double, double t) {
        return exact.traction(x, start + t);
    };
    return sources;
}

/// Where a node or a place in a cell is, on the grid below the exact surface.
class Places {
public:
    Places(const Grid& grid, const SurfaceField& surface) : grid_(grid), surface_(surface) {}

    Vector node(int i, int j) const { return {grid_.x(i), surface_[size_t(i)] + grid_.eta(j)}; }

    Vector in_cell(int i, int j, Local at) const {
        const double rise = at.a * grid_.dx(i) * grid_.slope(surface_, i);
        return {grid_.x(i) + at.a * grid_.dx(i),
                surface_[size_t(i)] + rise + grid_.eta(j) + at.b * grid_.height(j)};
    }

private:
    const Grid& grid_;
    const SurfaceField& surface_;
};

template <class Value, class Read>
void fill(Lattice<Value>& field, const Read& read) {
    for (int i = 0; i < field.columns(); ++i)
        for (int j = 0; j < field.rows(); ++j) field(i, j) = read(i, j);
}

SurfaceField exact_surface(const Grid& grid, const ManufacturedBurning& exact, double t) {
    SurfaceField surface;
    for (int i = 0; i < grid.node_columns(); ++i) surface.push_back(exact.surface(grid.x(i), t));
    return surface;
}

State exact_state(const Simulation& simulation, const ManufacturedBurning& exact, double t) {
    const Grid& grid = simulation.grid();
    State state = simulation.state();
    state.surface = exact_surface(grid, exact, t);
    const Places at(grid, state.surface);
    const auto at_node = [&](const auto& field) {
        return [&](int i, int j) { return field(at.node(i, j)); };
    };
    fill(state.temperature,
         at_node([&](const Vector& p) { return exact.temperature(p.x(), p.y(), t); }));
    fill(state.velocity, at_node([&](const Vector& p) { return exact.velocity(p.x(), p.y(), t); }));
    fill(state.reference_shift,
         at_node([&](const Vector& p) { return exact.shift(p.x(), p.y(), t); }));
    fill(state.temperature_rate, [&](int i, int j) {
        const Vector p = at.in_cell(i, j, cell_centre);
        return exact.temperature_rate(p.x(), p.y(), t);
    });
    const auto& points = stress_points(simulation.scene().numerics.element);
    const auto mean = [](const PlaneStress& s) { return (s.s11 + s.s22 + s.s33) / 3; };
    for (size_t k = 0; k < points.size(); ++k)
        fill(state.stress.deviator[k], [&](int i, int j) {
            const Vector p = at.in_cell(i, j, points[k]);
            const PlaneStress s = plane(exact.stress(p.x(), p.y(), t));
            return Deviator{s.s11 - mean(s), s.s22 - mean(s), s.s12};
        });
    fill(state.stress.pressure, [&](int i, int j) {
        const Vector p = at.in_cell(i, j, cell_centre);
        return -mean(plane(exact.stress(p.x(), p.y(), t)));
    });
    return state;
}

/// The exact states at t = 0 and, for a scheme that looks back, a step before.
State exact_start(const Simulation& simulation, const ManufacturedBurning& exact) {
    State state = exact_state(simulation, exact, 0.0);
    const Time& time = simulation.scene().time;
    if (time.scheme == Stepping::bdf2)
        state.previous = std::make_shared<const State>(exact_state(simulation, exact, -time.step));
    return state;
}

/// What the last steps before t = 0, all of them shorter than any of the run, make of the exact
/// state.
State settled_start(Scene scene, const ManufacturedBurning& exact) {
    constexpr int steps = 16;
    scene.time.step = scene.time.end / 4096;
    scene.time.scheme = Stepping::bdf2;
    const double before = -steps * scene.time.step;
    Simulation run(scene, sources(exact, before));
    State state = exact_state(run, exact, before);
    run.restore(state);
    run_steps(run, steps);
    state = run.state();
    state.step = 0;
    state.time = 0.0;
    state.previous.reset();
    return state;
}

/// Values found and exact, one quantity, with what each stands for.
struct Compared {
    std::vector<double> found, exact, weight;

    void add(double value, double truth, double size) {
        found.push_back(value);
        exact.push_back(truth);
        weight.push_back(size);
    }
};

void record(reports::Measurement& result, const std::string& quantity, const Compared& c) {
    result.field(quantity, c.found, c.exact, c.weight).sample(quantity, {c.found, c.weight});
}

void compare_surface(reports::Measurement& result, const Simulation& run,
                     const SurfaceField& exact) {
    Compared phi;
    for (size_t i = 0; i < exact.size(); ++i) phi.add(run.state().surface[i], exact[i], 1.0);
    record(result, "phi", phi);
}

void compare_nodes(reports::Measurement& result, const Simulation& run,
                   const ManufacturedBurning& exact, const Places& at) {
    const State& s = run.state();
    const Grid& grid = run.grid();
    Compared temperature, v, shift;
    for (int i = 0; i < grid.node_columns(); ++i)
        for (int j = 0; j <= grid.rows(); ++j) {
            const Vector p = at.node(i, j);
            const Vector velocity = exact.velocity(p.x(), p.y(), s.time);
            const Vector moved = exact.shift(p.x(), p.y(), s.time);
            const double size = grid.metric(j);
            temperature.add(s.temperature(i, j), exact.temperature(p.x(), p.y(), s.time), size);
            for (int c = 0; c < 2; ++c) {
                v.add(s.velocity(i, j)[c], velocity[c], size);
                shift.add(s.reference_shift(i, j)[c], moved[c], size);
            }
        }
    record(result, "T", temperature);
    record(result, "v", v);
    record(result, "xi", shift);
}

void compare_cells(reports::Measurement& result, const Simulation& run,
                   const ManufacturedBurning& exact, const Places& at) {
    const Grid& grid = run.grid();
    const auto f = run.deformation_gradient();
    const double time = run.state().time;
    Compared s11, s22, s33, s12, gradient;
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j) {
            const Vector p = at.in_cell(i, j, cell_centre);
            const PlaneStress found = run.state().stress.mean(i, j);
            const PlaneStress truth = plane(exact.stress(p.x(), p.y(), time));
            const double size = grid.height(j);
            s11.add(found.s11, truth.s11, size);
            s22.add(found.s22, truth.s22, size);
            s33.add(found.s33, truth.s33, size);
            s12.add(found.s12, truth.s12, size);
            const Eigen::Matrix2d stretch = exact.deformation_gradient(p.x(), p.y(), time);
            for (int row = 0; row < 2; ++row)
                for (int column = 0; column < 2; ++column)
                    gradient.add(f(i, j)(row, column), stretch(row, column), size);
        }
    record(result, "sigma_11", s11);
    record(result, "sigma_22", s22);
    record(result, "sigma_33", s33);
    record(result, "sigma_12", s12);
    record(result, "F", gradient);
}

void run_to_its_end(Simulation& run, const ManufacturedBurning& exact,
                    const ManufacturedBurn& burn) {
    run.restore(burn.start == Start::exact ? exact_start(run, exact)
                                           : settled_start(scene_of(burn), exact));
    run_steps(run, burn.steps);
}

}  // namespace

reports::Measurement run_manufactured(const ManufacturedBurn& burn, double h) {
    const ManufacturedBurning exact = truth();
    Simulation run(scene_of(burn), sources(exact, 0.0));
    run_to_its_end(run, exact, burn);

    reports::Measurement result(h);
    const SurfaceField surface = exact_surface(run.grid(), exact, run.state().time);
    const Places at(run.grid(), surface);
    compare_surface(result, run, surface);
    compare_nodes(result, run, exact, at);
    compare_cells(result, run, exact, at);
    return result;
}

std::vector<KnownValue> values_of_manufactured(const ManufacturedBurn& burn,
                                               const std::vector<Place>& places) {
    const ManufacturedBurning exact = truth();
    Simulation run(scene_of(burn), sources(exact, 0.0));
    run_to_its_end(run, exact, burn);

    const State& s = run.state();
    const SurfaceField surface = exact_surface(run.grid(), exact, s.time);
    std::vector<KnownValue> values;
    for (const Place& place : places) {
        const NodeIndex n = node_at(run.grid(), place);
        const Vector p = Places(run.grid(), surface).node(n.i, n.j);
        const auto add = [&](const char* what, const char* unit, double value, double expected) {
            values.push_back(
                {fmt::format("{} at {:g}, {:g} [{}]", what, place.across, place.up, unit), value,
                 expected});
        };
        const auto between = [&](const auto& component) {
            return between_cells(run.grid(), n,
                                 [&](int i, int j) { return component(s.stress.mean(i, j)); });
        };
        const PlaneStress stress = plane(exact.stress(p.x(), p.y(), s.time));
        add("T", "K", s.temperature(n.i, n.j), exact.temperature(p.x(), p.y(), s.time));
        add("v", "m/s", s.velocity(n.i, n.j).y(), exact.velocity(p.x(), p.y(), s.time).y());
        add("xi_y - y", "m", s.reference_shift(n.i, n.j).y(),
            exact.shift(p.x(), p.y(), s.time).y());
        add("phi", "m", s.surface[size_t(n.i)], surface[size_t(n.i)]);
        add("sigma_11", "Pa", between([](const PlaneStress& m) { return m.s11; }), stress.s11);
        add("sigma_12", "Pa", between([](const PlaneStress& m) { return m.s12; }), stress.s12);
    }
    return values;
}

}  // namespace crawford
