/// # Smooth projection: is the velocity the one that balances the loads?
///
/// One projection from a stress-free state is linear elasticity: a displacement v dt in equilibrium
/// with the forces inside and on the surface. Here the displacement is chosen first, some waves,
/// and the body force and traction that it needs follow from it by automatic differentiation
/// (reference/manufactured_elastic_body.hpp). The solver gets the loads and has to find the waves.
/// One material, K/mu = 3; without sources there is no way to vary moduli smoothly.
///
/// Bilinear elements are of second order in v. Their stress is too at the centre of a cell, where
/// the gradient of a bilinear interpolant is one order better than elsewhere; that holds on rows
/// whose height changes smoothly and below a surface of bounded curvature, and B-bar's loss of the
/// pressure that alternates over 2 x 2 cells is of the size p_xy h^2. Nothing here is singular, so
/// no other order has an excuse.
///
/// What each study adds: flat and uniform, the element by itself; wavy and clustered, the metric
/// and the slope of surface and bottom; rollers, a bottom free sideways but for the gas pressure on
/// its slope; half, the planes of symmetry; pressed, waves made so that the gas pressure alone is
/// their traction, in both readings of it.
///
/// On rollers a single node holds the body sideways, and nothing else stops an error of the shear
/// from moving the whole of it: v is off by as much as a third on 32 rows, of which the lowest is
/// 0.13 of the depth high, and its order comes up to 2 from below (1.79, 1.92, 1.97).

#include <array>
#include <cmath>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/projection/elastic_step.hpp"
#include "reference/manufactured_elastic_body.hpp"
#include "reference/truth_of.hpp"

namespace crawford {

namespace {

using namespace units;
using reference::ClampedWaves;
using reference::ElasticModuli;
using reference::ManufacturedElasticity;
using reference::PressedWaves;
using reference::RollingWaves;
using reference::WavyBody;
using reports::at_most;
using reports::expect;
using reports::Norm;

constexpr auto imbalance = "|div sigma + b| after the step, relative";
constexpr double pressure = 2.0 * MPa;
constexpr ElasticModuli moduli{.bulk = 30.0 * MPa, .shear = 10.0 * MPa};
constexpr double amplitude = 4.0 * um;
constexpr WavyBody flat{.width = 240.0 * um, .depth = 240.0 * um, .height = 0.0, .phase = 0.7};
constexpr WavyBody wavy{
    .width = 240.0 * um, .depth = 240.0 * um, .height = 12.0 * um, .phase = 0.7};
constexpr WavyBody symmetric{
    .width = 240.0 * um, .depth = 240.0 * um, .height = 12.0 * um, .phase = 0.0};

/// A body, how it is held and pressed, and the displacement chosen for it.
struct Chosen {
    WavyBody body;
    ManufacturedElasticity truth;
    bool needs_traction = true;  ///< beside the pressure's
    Support support = Support::clamped;
    double pressure = 0.0;
    Traction reading = Traction::normal;
    double clustering = 2.0;
    bool half = false;
};

Scene scene(const Chosen& chosen, Element element, int cells) {
    Scene scene;
    scene.domain = {.width = chosen.body.width,
                    .depth = chosen.body.depth,
                    .nx = cells,
                    .ny = cells,
                    .clustering = chosen.clustering,
                    .half = chosen.half};
    Material& material = scene.morphology.materials.front();
    material.bulk_modulus = moduli.bulk;
    material.shear_modulus = moduli.shear;
    scene.surface = {.pressure = chosen.pressure, .traction = chosen.reading};
    scene.bottom.support = chosen.support;
    scene.numerics.element = element;
    return scene;
}

/// What the exact stress needs on the surface, less what the gas pressure already gives.
Vector missing_traction(const Chosen& chosen, double x, double y) {
    const double slope = chosen.body.slope(x);
    const Vector normal = Vector(-slope, 1.0) / std::hypot(1.0, slope);
    return reference::traction(chosen.truth.stress(x, y), slope) + chosen.pressure * normal;
}

reports::Measurement measure(const Chosen& chosen, Element element, int cells) {
    const auto& truth = chosen.truth;
    ProjectionSources sources{
        .body_force = [&](double x, double y, double) { return truth.body_force(x, y); }};
    if (chosen.needs_traction)
        sources.traction = [&](double x, double y, double) {
            return missing_traction(chosen, x, y);
        };
    const ElasticStep step(
        scene(chosen, element, cells), [&](double x) { return chosen.body.surface(x); }, sources);

    reports::Measurement result(1.0 / cells);
    result.value(imbalance, step.residual());
    const reference::Truth exact = reference::truth_of(truth);
    step.compare_displacement("v", exact, result);
    step.compare_stress("", exact, result);
    return result;
}

constexpr std::array components{"sigma_11", "sigma_22", "sigma_33", "sigma_12", "pressure"};

/// One element by itself: asymptotic from the coarsest grid.
reports::Study on_flat(const std::string& name, Element element) {
    const Chosen chosen{
        .body = flat, .truth = {ClampedWaves{flat, amplitude}, moduli}, .clustering = 0.0};
    const auto second = expect(2.0).within(0.1);
    reports::Study study("projection-smooth, flat, " + name);
    study.refines("cells", {32, 64, 128})
        .measure([=](int cells) { return measure(chosen, element, cells); })
        .covers({term::elasticity, term::equilibrium})
        .gate("v", Norm::L2, second, "bilinear elements, loads by trapezoids: h^2 each")
        .gate("v", Norm::Linf, second, "smooth up to surface and bottom");
    for (const auto component : components)
        study.gate(component, Norm::L2, second, "gradient at a cell centre: exact for parabolas");
    return study;
}

reports::Study below_waves(const std::string& name, const Chosen& chosen,
                           const std::vector<std::string>& terms, Element element = Element::bbar) {
    const auto second = expect(2.0).within(0.1).from(64);
    reports::Study study("projection-smooth, " + name);
    study.refines("cells", {32, 64, 128, 256})
        .measure([=](int cells) { return measure(chosen, element, cells); })
        .covers(terms)
        .gate("v", Norm::L2, second,
              "as on a flat grid; of 32 clustered rows the lowest is 0.13 of the depth high")
        .gate("v", Norm::Linf, second, "smooth up to surface and bottom");
    for (const auto component : components)
        study.gate(component, Norm::L2, second,
                   "gradient at a cell centre; heights and slopes change by h from cell to cell");
    if (element == Element::bbar)
        study.bound(imbalance, 64, at_most(1e-12),
                    "B-bar carries its stress where it integrates it: round-off, 1e-15 to 3e-15");
    return study;
}

std::vector<reports::Study> studies() {
    const Chosen clamped{.body = wavy, .truth = {ClampedWaves{wavy, amplitude}, moduli}};
    const Chosen rolling{.body = wavy,
                         .truth = {RollingWaves{wavy, moduli, amplitude, pressure}, moduli},
                         .support = Support::roller,
                         .pressure = pressure};
    const Chosen half{
        .body = symmetric, .truth = {ClampedWaves{symmetric, amplitude}, moduli}, .half = true};
    const Chosen pressed{.body = wavy,
                         .truth = {PressedWaves{wavy, moduli, amplitude, {-pressure, 0.0}}, moduli},
                         .needs_traction = false,
                         .pressure = pressure};
    const Chosen vertical{
        .body = wavy,
        .truth = {PressedWaves{wavy, moduli, amplitude, {0.0, -pressure}}, moduli},
        .needs_traction = false,
        .pressure = pressure,
        .reading = Traction::vertical};
    const std::vector<std::string> grid{term::elasticity, term::equilibrium, term::clustering,
                                        term::slope};
    const std::vector<std::string> load{term::traction, term::equilibrium, term::slope};
    return {on_flat("B-bar", Element::bbar),
            on_flat("q1", Element::q1),
            below_waves("wavy, B-bar", clamped, grid),
            below_waves("wavy, q1", clamped, grid, Element::q1),
            below_waves("wavy, on rollers", rolling, {term::support, term::traction, term::slope}),
            below_waves("wavy, half", half, {term::support, term::equilibrium}),
            below_waves("pressed", pressed, load),
            below_waves("pressed vertically", vertical, load)};
}

const Registered here{{.name = "projection-smooth",
                       .figure = "-",
                       .shows = "projection against smooth manufactured displacements",
                       .cost = {.verify = 15.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
