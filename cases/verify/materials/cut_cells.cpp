/// # Cut cells: which mean of two materials should a cell hold that an interface cuts?
///
/// Conductivity. Beside each other in the direction of the heat two materials conduct as the
/// arithmetic mean of their conductivities, behind each other as the harmonic one. A cut cell can
/// be given either, or both: read as a laminate it conducts as the harmonic mean along the normal
/// of its interface and as the arithmetic mean across that normal. Each is tried on exact steady or
/// swinging fields whose interface lies inside cells, 5 : 1 in conductivity: heat that crosses a
/// strip's edges while some runs along them (reference/thermal_laminate.hpp), heat that only runs
/// along them (a linear T), and heat past a disc (reference/conducting_inclusion.hpp). An isotropic
/// mean must be wrong for one of the two directions, by a fixed amount in cells that take a share h
/// of the area: order 1. The laminate is right for both: order 2 where the interface is straight.
/// It is never the worse one, and so it is the default. (Between AP and binder, 1.5 : 1, it hardly
/// matters: the mean burn rate of a pack on 60 x 48 cells moves by 0.01 %.)
///
/// Moduli. A laminate is anisotropic, and its stiffness is more than the two numbers of which the
/// solver makes its stresses (one mu also says how far a stress softens that is carried into a
/// cell, and how viscous the cell is), so only isotropic means are to be had, and both are of
/// order 1. Which is nearer depends on how the cut cells are loaded. Around a stiff disc in a soft
/// matrix (reference/faded_inclusion.hpp) they are loaded across the interface, and the harmonic
/// mean has a fourteenth of the error of the arithmetic one; around a soft disc in a stiff matrix
/// they carry a hoop stress along it, and it has five times the error. A strip pressed along its
/// layers (reference/elastic_laminate.hpp) is in between. A pack is stiff discs in a soft matrix,
/// and it burns: with the arithmetic mean a cell that turns from AP into binder stays stiff until
/// the last of AP is gone and drops its stress at once (strains of 3.5 instead of 0.4). The default
/// is harmonic.

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/verify/heat/heated_laminate.hpp"
#include "cases/verify/projection/elastic_inclusion.hpp"
#include "cases/verify/projection/pressed_laminate.hpp"
#include "reference/conducting_inclusion.hpp"

namespace crawford {

namespace {

using namespace units;
using reference::TwoConductors;
using reports::at_most;
using reports::between;
using reports::expect;
using reports::Measurement;
using reports::Norm;

const std::vector<std::pair<CutConductivity, std::string>> conductivities{
    {CutConductivity::arithmetic, ", arithmetic"},
    {CutConductivity::harmonic, ", harmonic"},
    {CutConductivity::laminate, ", laminate"}};
const std::vector<std::pair<CutModuli, std::string>> moduli{{CutModuli::arithmetic, ", arithmetic"},
                                                            {CutModuli::harmonic, ", harmonic"}};

double error(const Measurement& measured, const std::string& quantity) {
    return measured.error_of(quantity, Norm::L2).value().error;
}

/// The harmonic form's error in units of the arithmetic one's.
void compare(Measurement& result, const std::string& quantity) {
    result.value(quantity + ", harmonic / arithmetic",
                 error(result, quantity + ", harmonic") / error(result, quantity + ", arithmetic"));
}

constexpr auto ring = "moduli wrong by a fixed amount in cells that take a share h of the area";

/// The error of T with every form of the average.
Measurement every_conductivity(PrescribedHeat heat, int cells) {
    Measurement result(1.0 / cells);
    for (const auto& [form, name] : conductivities) {
        heat.scene.numerics.cut_cell_conductivity = form;
        const FoundHeat found = advance(heat, cells / 8);
        result.field("T" + name, found.temperature, found.exact, found.weight);
        result.value("T" + name + " [K]", error(result, "T" + name));
    }
    const double best_other =
        std::min(error(result, "T, arithmetic"), error(result, "T, harmonic"));
    result.value("T, laminate / best other", error(result, "T, laminate") / best_other);
    return result;
}

Measurement across(const TwoConductors& solid, int cells) {
    return every_conductivity(heated_laminate(widened(solid, cells), cells), cells);
}

/// T rises evenly from the bottom to the surface, whatever conducts.
Measurement along(const TwoConductors& solid, int cells) {
    PrescribedHeat heat = heated_laminate(widened(solid, cells), cells);
    heat.sources = {};
    heat.temperature = [solid](double, double y, double) {
        return solid.cold_temperature + solid.rise * (1.0 + y / solid.depth);
    };
    return every_conductivity(heat, cells);
}

Measurement around(const TwoConductors& solid, int cells) {
    const Vector centre(1.7 * um, -118.1 * um);  // on no grid line
    const double radius = 40.0 * um;
    const reference::ConductingInclusion truth({.inner_conductivity = solid.inner_conductivity,
                                                .outer_conductivity = solid.outer_conductivity,
                                                .radius = radius,
                                                .temperature = solid.cold_temperature,
                                                .gradient_x = 1.0 / um,
                                                .gradient_y = 0.5 / um,
                                                .whole = 55.0 * um,
                                                .gone = 115.0 * um});
    PrescribedHeat heat = heated_laminate(solid, cells);
    heat.scene.domain.ny = cells;
    heat.scene.domain.clustering = 0.0;
    heat.scene.morphology.shape =
        Discs{.discs = {{centre.x(), centre.y(), radius}}, .period = 10.0 * solid.width};
    std::swap(heat.scene.morphology.materials.front(), heat.scene.morphology.materials.back());
    heat.scene.surface.heat_flux = {0.0, 0.0};
    heat.sources = {.heat = [=](double x, double y, double) {
        return truth.source(x - centre.x(), y - centre.y());
    }};
    heat.temperature = [=](double x, double y, double) {
        return truth.temperature(x - centre.x(), y - centre.y());
    };
    return every_conductivity(heat, cells);
}

Measurement elastic_disc(const DiscAndMatrix& pair, int cells) {
    Measurement result(1.0 / cells);
    Scene scene = inclusion_scene(pair, cells);
    for (const auto& [form, name] : moduli) {
        scene.numerics.cut_cell_moduli = form;
        measure_inclusion(scene, faded_inclusion(pair), name, result);
    }
    compare(result, "displacement");
    return result;
}

Measurement elastic_strip(int cells) {
    const auto laminate = pressed_laminate::matched(130.0 * um);
    Measurement result(1.0 / cells);
    Scene scene = pressed_laminate::scene(laminate, cells, 0.0);
    for (const auto& [form, name] : moduli) {
        scene.numerics.cut_cell_moduli = form;
        const pressed_laminate::Run run(laminate, scene);
        result.field("v" + name, run.v, run.v_exact);
    }
    compare(result, "v");
    return result;
}

reports::Study heat(const std::string& what, const std::function<Measurement(int)>& measure) {
    reports::Study study("cut-cells, heat " + what);
    study.refines("cells", {32, 64, 128, 256}).measure(measure).covers({term::heat_interface});
    return study;
}

std::vector<reports::Study> heat_studies() {
    const TwoConductors solid = conductors(0.2, 1.0);
    const auto first = expect(1.0).within(0.15).from(64);
    auto strip = heat("across a strip", [=](int cells) { return across(solid, cells); });
    strip.gate("T, arithmetic", Norm::L2, first, "conducts too much across: a missing drop of h")
        .gate("T, harmonic", Norm::L2, first, "conducts too little along, where T varies along too")
        .gate("T, laminate", Norm::L2, expect(2.0).within(0.1).from(64),
              "right both ways: what is left is the elements'")
        .bound("T, laminate / best other", 256, at_most(0.2), "an order better by now");
    auto layers = heat("along a strip", [=](int cells) { return along(solid, cells); });
    layers
        .gate("T, harmonic", Norm::L2, expect(1.0).within(0.1),
              "a column of width h conducts less than enters it")
        .bound("T, laminate [K]", 256, at_most(1e-8), "a linear T, exact but for the relaxation")
        .bound("T, arithmetic [K]", 256, at_most(1e-8), "the same");
    auto disc = heat("past a disc", [=](int cells) { return around(solid, cells); });
    disc.gate("T, arithmetic", Norm::L2, first, "too much across: a ring of width h")
        .gate("T, harmonic", Norm::L2, expect(1.0).within(0.3).from(64),
              "too little along, less than the elements' error of order 2 on coarse grids")
        .bound("T, laminate / best other", 256, at_most(0.9), "right both ways around the circle");
    return {strip, layers, disc};
}

reports::Study elastic(const std::string& what, const DiscAndMatrix& pair) {
    reports::Study study("cut-cells, " + what);
    study.refines("cells", {32, 64, 128, 256})
        .measure([=](int cells) { return elastic_disc(pair, cells); })
        .covers({term::elastic_interface})
        .gate("displacement, arithmetic", Norm::L2, expect(1.0).within(0.15), ring)
        .gate("displacement, harmonic", Norm::L2, expect(1.0).within(0.15).from(64), ring);
    return study;
}

std::vector<reports::Study> studies() {
    reference::Material soft = reference::ap();
    soft.bulk_modulus /= 100.0;
    soft.shear_modulus /= 100.0;
    auto stiff_disc = elastic("stiff disc", {reference::ap(), soft});
    stiff_disc.bound("displacement, harmonic / arithmetic", 256, at_most(0.1),
                     "what is soft between stiff things yields first: in series");
    auto soft_disc = elastic("soft disc", {reference::binder(), reference::ap()});
    soft_disc.bound("displacement, harmonic / arithmetic", 256, between(3.0, 6.0),
                    "the price: a ring that holds a soft disc carries along itself, in parallel");
    reports::Study strip("cut-cells, pressed strip");
    strip.refines("columns", {16, 64, 256})
        .measure(elastic_strip)
        .covers({term::elastic_interface})
        .gate("v, arithmetic", Norm::L2, expect(1.0).within(0.1), ring)
        .gate("v, harmonic", Norm::L2, expect(1.0).within(0.1), ring)
        .bound("v, harmonic / arithmetic", 256, at_most(0.35),
               "neither is the laminate's; K/mu differs 361-fold, and the harmonic one is nearer");
    std::vector<reports::Study> all = heat_studies();
    all.insert(all.end(), {stiff_disc, soft_disc, strip});
    return all;
}

const Registered here{
    {.name = "cut-cells",
     .figure = "-",
     .shows = "which mean of two materials a cell should hold that an interface cuts",
     .cost = {.verify = 25.0},
     .studies = studies}};

}  // namespace

}  // namespace crawford
