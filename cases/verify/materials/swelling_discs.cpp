/// # Swelling discs: how much does a cell expand that an interface cuts?
///
/// Discs that swell more than the solid around them, but are as stiff, heated evenly between
/// rollers. By Betti's theorem the mean rise of the free surface depends on neither where nor in
/// what shape the swelling material lies, but on its area alone: with P = K + 4 mu/3,
///
///     (mean rise) = (integral of beta dT dA)/(P width),
///
/// and this holds for the finite elements as well, whose fields hold a uniform stress exactly. What
/// the discs add to the rise is therefore exact on every grid if a cut cell has the area's mean of
/// the expansion; any other mean is wrong by a share h.

#include <cmath>
#include <numbers>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "reference/material.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::between;

constexpr double width = 240.0 * um;
constexpr double heating = 30.0;               // [K]
constexpr double expansion = 1e-7;             // [1/K] so small that strains add up to 1e-5
constexpr double swelling = 10.0 * expansion;  // [1/K] of the discs
constexpr int steps = 4;
constexpr double duration = 1.0 * ms;

/// Whole in the window and far from its bottom, which is held cold; on no grid line.
const std::vector<Disc> discs{{21.3 * um, -70.1 * um, 50.2 * um},
                              {-70.7 * um, -90.9 * um, 31.4 * um}};

Scene scene(int cells, const std::vector<Disc>& held) {
    Material outer = ammonium_perchlorate();
    outer.thermal_expansion = expansion;
    Material inner = outer;
    inner.thermal_expansion = swelling;
    Scene scene;
    scene.domain = {.width = width, .depth = width, .nx = cells, .ny = cells, .clustering = 1.0};
    scene.morphology = {.shape = Discs{.discs = held, .period = 2.0 * width},
                        .materials = {inner, outer}};
    scene.physics.regression = Regression::none;
    scene.surface.heat_flux = {0.0, 0.0};
    scene.time.step = duration / steps;
    return scene;
}

/// Mean rise of the surface [m] under `heating`.
double rise(int cells, const std::vector<Disc>& held) {
    const Scene heated = scene(cells, held);
    const reference::Material ap = reference::ap();
    Sources sources;
    sources.heat = [rate = ap.density * ap.specific_heat * heating / duration](
                       double, double, double) { return rate; };
    Simulation simulation(heated, sources);
    run_steps(simulation, steps);
    const NodeVectors& shift = simulation.state().reference_shift;
    double sum = 0.0;
    for (int i = 0; i < shift.columns(); ++i) sum -= shift(i, cells).y();
    return sum / shift.columns();
}

double exact_further_rise() {
    double area = 0.0;
    for (const Disc& disc : discs) area += std::numbers::pi * disc.radius * disc.radius;
    const reference::Material ap = reference::ap();
    return 3.0 * (swelling - expansion) * ap.bulk_modulus * heating * area /
           (ap.uniaxial_modulus() * width);
}

std::vector<reports::Study> studies() {
    constexpr auto ratio = "rise by the discs / exact";
    reports::Study study("swelling-discs");
    study.refines("cells", {32, 64})
        .covers({term::thermal_stress, term::elastic_interface})
        .measure([](int cells) {
            const double found = rise(cells, discs) - rise(cells, {});
            return reports::Measurement(1.0 / cells).value(ratio, found / exact_further_rise());
        })
        .bound(ratio, 64, between(1.0 - 1e-4, 1.0 + 1e-4),
               "exact for small strains, and these are 1e-5; the harmonic mean is 5 % low");
    return {study};
}

const Registered here{{.name = "swelling-discs",
                       .figure = "-",
                       .shows = "a cut cell expands as the material in it does",
                       .physics = {physics::pack},
                       .cost = {.verify = 3.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
