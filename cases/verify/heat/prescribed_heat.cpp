#include "cases/verify/heat/prescribed_heat.hpp"

#include <cmath>

#include "cases/units.hpp"
#include "solver/heat/heat_step.hpp"

namespace crawford {

namespace {

/// The prescribed fields on the nodes and cells of a grid.
class Prescribed {
public:
    Prescribed(const PrescribedHeat& heat, const Grid& grid) : heat_(heat), grid_(grid) {}

    SurfaceField line(const PrescribedHeat::Line& f, double t) const {
        SurfaceField values(size_t(grid_.node_columns()), 0.0);
        for (int i = 0; f && i < grid_.node_columns(); ++i) values[size_t(i)] = f(grid_.x(i), t);
        return values;
    }

    NodeField temperature(double t) const {
        const SurfaceField surface = line(heat_.surface, t);
        NodeField values(grid_.node_columns(), grid_.rows() + 1);
        for (int i = 0; i < values.columns(); ++i)
            for (int j = 0; j < values.rows(); ++j)
                values(i, j) = heat_.temperature(grid_.x(i), surface[size_t(i)] + grid_.eta(j), t);
        return values;
    }

    NodeVectors velocity(double t) const {
        if (!heat_.velocity) return {};
        const SurfaceField surface = line(heat_.surface, t);
        NodeVectors values(grid_.node_columns(), grid_.rows() + 1);
        for (int i = 0; i < values.columns(); ++i)
            for (int j = 0; j < values.rows(); ++j)
                values(i, j) = heat_.velocity(grid_.x(i), surface[size_t(i)] + grid_.eta(j), t);
        return values;
    }

    CellField material_rate(double t) const {
        if (!heat_.material_rate) return {};
        const SurfaceField surface = line(heat_.surface, t);
        CellField values(grid_.cell_columns(), grid_.rows());
        for (int i = 0; i < values.columns(); ++i)
            for (int j = 0; j < values.rows(); ++j) {
                const double top =
                    0.5 * (surface[size_t(i)] + surface[size_t(grid_.right_node(i))]);
                values(i, j) = heat_.material_rate(grid_.x(i) + 0.5 * grid_.dx(i),
                                                   top + grid_.eta(j) + 0.5 * grid_.height(j), t);
            }
        return values;
    }

private:
    const PrescribedHeat& heat_;
    const Grid& grid_;
};

}  // namespace

Scene heated_block(const Material& material, int cells, double clustering) {
    Scene scene;
    scene.domain = {.width = 240.0 * units::um,
                    .depth = 240.0 * units::um,
                    .nx = cells / 2,
                    .ny = cells,
                    .clustering = clustering};
    scene.morphology.materials = {material};
    scene.physics = {.mechanics = false, .reference_map = false, .regression = Regression::none};
    scene.surface.heat_flux = {0.0};
    scene.time.end = 1.0 * units::ms;
    return scene;
}

reference::HeatedSolid heated_block(const reference::Material& material) {
    return {.conductivity = material.thermal_conductivity,
            .capacity = material.density * material.specific_heat,
            .width = 240.0 * units::um,
            .depth = 240.0 * units::um,
            .cold_temperature = 300.0,
            .rise = 300.0};
}

PrescribedHeat manufactured(const Scene& scene, const reference::HeatedSolid& solid) {
    const reference::ManufacturedHeat truth(solid);
    PrescribedHeat heat{.scene = scene};
    heat.temperature = [truth](double x, double y, double t) { return truth.temperature(x, y, t); };
    heat.surface = [truth](double x, double t) { return truth.surface(x, t); };
    heat.surface_rate = [truth](double x, double t) { return truth.surface_rate(x, t); };
    if (solid.speed != 0.0)
        heat.velocity = [truth](double x, double y, double t) {
            const auto [u, v] = truth.velocity(x, y, t);
            return Vector{u, v};
        };
    if (scene.physics.mechanics && scene.numerics.coupling == Coupling::adiabatic)
        heat.material_rate = [truth](double x, double y, double t) {
            return truth.material_rate(x, y, t);
        };
    heat.sources.heat = [truth](double x, double y, double t) { return truth.source(x, y, t); };
    heat.sources.heat_flux = [truth](double x, double, double t) {
        return truth.surface_flux(x, t);
    };
    return heat;
}

PrescribedHeat burning(Scene scene, const reference::HeatedSolid& solid,
                       const reference::Material& material) {
    const double flame = 100.0 * units::cal / (units::s * units::cm2);
    scene.physics.regression = Regression::pyrolysis;
    scene.surface.heat_flux = {flame};
    PrescribedHeat heat = manufactured(scene, solid);
    heat.sources.heat_flux = [truth = reference::ManufacturedHeat(solid), material, flame](
                                 double x, double, double t) {
        const double temperature = truth.temperature(x, truth.surface(x, t), t);
        const double rate =
            material.pyrolysis_prefactor * std::exp(-material.activation_temperature / temperature);
        return truth.surface_flux(x, t) - flame -
               material.heat_of_reaction * material.density * rate;
    };
    return heat;
}

FoundHeat advance(const PrescribedHeat& heat, int steps) {
    const Scene& scene = heat.scene;
    const Grid grid(scene.domain);
    const MaterialMap materials(scene.morphology, grid, scene.numerics);
    const BurningLaw law(scene.physics.regression, scene.surface);
    HeatStep step(scene, grid, materials, law, heat.sources);

    const Prescribed prescribed(heat, grid);
    NodeField temperature = prescribed.temperature(heat.start);
    CellField temperature_rate = prescribed.material_rate(heat.start);
    const double dt = (scene.time.end - heat.start) / steps;
    for (int k = 0; k < steps; ++k) {
        const double time = heat.start + k * dt;
        const double when = time + heat.motion_at * dt;
        const SurfaceField surface = prescribed.line(heat.surface, when);
        const SurfaceField surface_rate = prescribed.line(heat.surface_rate, when);
        const NodeVectors velocity = prescribed.velocity(when);
        const HeatMotion motion{{surface, surface_rate, velocity}, temperature_rate};
        const NodeField before = temperature;
        step.advance(temperature, motion, time, dt);
        if (heat.material_rate) {
            CellField rate = temperature_rate;
            material_rate(grid, before, temperature, motion, dt, rate);
            temperature_rate = rate;
        }
    }
    return {temperature.values(), prescribed.temperature(scene.time.end).values(),
            node_areas(grid).values()};
}

reports::Measurement error_of_temperature(const FoundHeat& found, double h) {
    return reports::Measurement(h).field("T", found.temperature, found.exact, found.weight);
}

}  // namespace crawford
