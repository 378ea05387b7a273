/// Displacements and stresses of one elastic step at single places: the problems of
/// cases/verify/projection.
#include <fmt/format.h>

#include <cmath>

#include "cases/explore/coverage/known_problem.hpp"
#include "cases/units.hpp"
#include "cases/verify/projection/elastic_inclusion.hpp"
#include "cases/verify/projection/elastic_step.hpp"
#include "reference/manufactured_elastic_body.hpp"
#include "reference/manufactured_elastic_strip.hpp"

namespace crawford {

namespace {

using namespace units;
using reference::ElasticModuli;
using reference::ManufacturedElasticity;
using reference::WavyBody;
using Places = std::vector<Place>;

constexpr ElasticModuli moduli{.bulk = 30.0 * MPa, .shear = 10.0 * MPa};
constexpr double amplitude = 4.0 * um;

Material material_of(const ElasticModuli& of) {
    Material material;
    material.bulk_modulus = of.bulk;
    material.shear_modulus = of.shear;
    return material;
}

/// At places below the surface, and displacements on it.
template <class Truth>
std::vector<KnownValue> values_of(const ElasticStep& step, const Truth& truth,
                                  const Places& places) {
    const Grid& grid = step.grid();
    std::vector<KnownValue> values;
    for (const Place& place : places) {
        const NodeIndex n = node_at(grid, place);
        const double x = grid.x(n.i), y = step.surface()[size_t(n.i)] + grid.eta(n.j);
        const auto add = [&](const char* what, const char* unit, double value, double exact) {
            values.push_back(
                {fmt::format("{} at {:g}, {:g} [{}]", what, place.across, place.up, unit), value,
                 exact});
        };
        const auto stress = [&](double PlaneStress::*component) {
            return between_cells(grid, n,
                                 [&](int i, int j) { return step.stress().mean(i, j).*component; });
        };
        const Vector moved = step.displacement()(n.i, n.j);
        const auto exact = truth.displacement(x, y);
        if (place.across > 0.0) add("u", "m", moved.x(), exact.x());
        add("v", "m", moved.y(), exact.y());
        if (place.up == 1.0 || place.across == 0.0) continue;
        add("sigma_11", "Pa", stress(&PlaneStress::s11), truth.stress(x, y).xx);
        add("sigma_12", "Pa", stress(&PlaneStress::s12), truth.stress(x, y).xy);
    }
    return values;
}

KnownProblem body(Fidelity fidelity, const std::string& name, const WavyBody& body,
                  const ManufacturedElasticity& truth, double clustering, Support support) {
    return {
        "elastic body", "elastic body, " + name, 2.0, grids_of(fidelity, 4), [=](int cells) {
            Scene scene;
            scene.domain = {.width = body.width,
                            .depth = body.depth,
                            .nx = cells,
                            .ny = cells,
                            .clustering = clustering};
            scene.morphology.materials = {material_of(moduli)};
            scene.surface.pressure = 0.0;
            scene.bottom.support = support;
            const ProjectionSources sources{
                .body_force = [&](double x, double y, double) { return truth.body_force(x, y); },
                .traction = [&](double x, double y, double) -> Vector {
                    return reference::traction(truth.stress(x, y), body.slope(x));
                }};
            const ElasticStep step(
                scene, [&](double x) { return body.surface(x); }, sources);
            return values_of(step, truth, {{0.25, 0.5}, {0.5, 0.75}, {0.25, 1.0}});
        }};
}

/// Faces on grid lines. \see cases/verify/projection/projection_contrast.cpp
KnownProblem strip(Fidelity fidelity, const std::string& name, double contrast,
                   double incompressibility) {
    return {
        "elastic strip", "elastic strip, " + name, 2.0, grids_of(fidelity, 8), [=](int cells) {
            constexpr double soft = 2.5 * MPa;
            const reference::ElasticStrip solid{
                .width = 1.0,
                .strip = 0.25,
                .depth = 0.5,
                .outer = {.bulk = 1.2 * contrast * soft, .shear = contrast * soft},
                .inner = {.bulk = incompressibility * soft, .shear = soft},
                .stress = 1.0 * MPa};
            const reference::ManufacturedStrip truth(solid);
            Scene scene;
            scene.domain = {.width = solid.width,
                            .depth = solid.depth,
                            .nx = cells,
                            .ny = cells / 2,
                            .clustering = 0.0,
                            .half = true};
            scene.morphology = {.shape = Sandwich{solid.strip},
                                .materials = {material_of(solid.outer), material_of(solid.inner)}};
            scene.bottom.support = Support::clamped;
            scene.numerics.viscous_time = 0.0;
            const ProjectionSources sources{
                .body_force = [&](double x, double y, double) { return truth.body_force(x, y); },
                .traction = [&](double x, double y, double) -> Vector {
                    return reference::traction(truth.stress(x, y), 0.0);
                }};
            const ElasticStep step(
                scene, [](double) { return 0.0; }, sources);
            return values_of(step, truth, {{0.0, 0.5}, {0.5, 0.5}, {0.75, 0.75}, {0.75, 1.0}});
        }};
}

KnownProblem inclusion(Fidelity fidelity, const std::string& name, double order,
                       const DiscAndMatrix& pair) {
    return {"inclusion", "inclusion, " + name, order, grids_of(fidelity, 8), [=](int cells) {
                return values_of_inclusion(inclusion_scene(pair, cells), faded_inclusion(pair),
                                           {{0.25, 0.5}, {0.375, 0.5}, {0.5, 0.5}, {0.5, 0.75}});
            }};
}

}  // namespace

std::vector<KnownProblem> elastic_problems(Fidelity fidelity) {
    constexpr WavyBody flat{.width = 240.0 * um, .depth = 240.0 * um, .height = 0.0, .phase = 0.7};
    constexpr WavyBody wavy{
        .width = 240.0 * um, .depth = 240.0 * um, .height = 12.0 * um, .phase = 0.7};
    const auto clamped = [](const WavyBody& body) {
        return ManufacturedElasticity{reference::ClampedWaves{body, amplitude}, moduli};
    };
    return {
        body(fidelity, "flat", flat, clamped(flat), 0.0, Support::clamped),
        body(fidelity, "wavy", wavy, clamped(wavy), 2.0, Support::clamped),
        body(fidelity, "on rollers", wavy,
             {reference::RollingWaves{wavy, moduli, amplitude, 0.0}, moduli}, 2.0, Support::roller),
        strip(fidelity, "moduli 1e2", 1e2, 1e2),
        strip(fidelity, "moduli 1e4, nearly incompressible", 1e4, 1e5),
        inclusion(fidelity, "none", 2.0, {reference::ap(), reference::ap()}),
        inclusion(fidelity, "binder in AP", 1.0, {reference::binder(), reference::ap()})};
}

}  // namespace crawford
