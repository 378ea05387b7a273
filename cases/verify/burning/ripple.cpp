/// # Ripple: how fast does an uneven front become flat?
///
/// A crest of the front stands above its own thermal layer and burns faster, a valley is shielded
/// and burns slower: a ripple dies. How fast is exact (reference/front_ripple.hpp), to second order
/// in the amplitude: the only truth that is unsteady, two-dimensional, and of heat, pyrolysis and
/// the sloped surface together. One wave over 240 um of AP, K = k D/r = 0.9, where conduction along
/// the front counts as much as across it.
///
/// The scene's `surface.ripple` is the start of the surface, the exact mode that of the temperature;
/// half a period is modelled. The amplitude of the first harmonic is read over one time constant,
/// in which it falls to a third. Rows and steps go with the columns.
///
/// What the truth leaves out is of second order in the amplitude: 7e-6 at 0.1 um. It is measured by
/// itself, on one grid, with ripples of up to 8 um.

#include <cmath>
#include <limits>
#include <numbers>

#include "cases/registry.hpp"
#include "cases/scenes/slab.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/burning/exact_start.hpp"
#include "cases/verify/burning/series.hpp"
#include "reference/front_ripple.hpp"
#include "solver/run/loop.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::between;
using reports::expect;
using reports::Norm;

constexpr double width = 240.0 * um;
constexpr double wave_number = 2.0 * std::numbers::pi / width;

Slab slab_of(int rows) {
    return slab("AP", {.cells = rows, .clustering = 2.0, .depth = 480.0 * um})
        .burning_by_law()
        .heated(200.0 * cal / (s * cm2))
        .rigid();
}

Scene scene_of(double amplitude, int columns) {
    const int rows = columns * 3 / 2;
    Scene scene = slab_of(rows).scene();
    scene.domain.width = width;
    scene.domain.nx = columns;
    scene.domain.half = true;
    scene.surface.ripple = {.amplitude = amplitude, .waves = 1};
    scene.time.scheme = Stepping::bdf2;
    scene.time.step = 40.0 * us * 64 / columns;
    return scene;
}

/// Amplitude [m] of cos(k x) in the surface of half a period.
double first_harmonic(const Grid& grid, const SurfaceField& surface) {
    double sum = 0.0;
    for (int i = 0; i < grid.node_columns(); ++i) {
        const double share = i == 0 || i + 1 == grid.node_columns() ? 0.5 : 1.0;
        sum += share * surface[size_t(i)] * std::cos(wave_number * grid.x(i));
    }
    return 2.0 * sum / grid.cell_columns();
}

constexpr auto rate = "rate";
constexpr auto rate_off = "rate/exact - 1";

reports::Measurement measure(double amplitude, int columns, double h) {
    auto conditions = slab_of(1).conditions(reference::SlabModel::thermal);
    conditions.depth = std::numeric_limits<double>::infinity();
    const reference::FrontRipple exact(conditions, wave_number);

    Simulation simulation(scene_of(amplitude, columns));
    const double start = first_harmonic(simulation.grid(), simulation.state().surface);
    const auto height = [&](double x, double t) {
        return start * std::cos(wave_number * x) * std::exp(exact.growth_rate() * t);
    };
    start_exactly(
        simulation,
        {.surface = [&](double x, double t) { return height(x, t) - exact.front().burn_rate * t; },
         .temperature =
             [&](double x, double eta, double t) {
                 return exact.front().temperature(eta) + height(x, t) * exact.temperature(eta);
             }});
    const Grid& grid = simulation.grid();
    std::vector<double> harmonic{first_harmonic(grid, simulation.state().surface)};
    const double step = simulation.scene().time.step;
    run_steps(simulation, std::lround(-1.0 / (exact.growth_rate() * step)),
              {[&](Simulation& s, double) {
                  harmonic.push_back(first_harmonic(grid, s.state().surface));
              }});
    const double found = plain_growth(harmonic, step);
    return reports::Measurement(h)
        .value(rate, found, exact.growth_rate())
        .value(rate_off, found / exact.growth_rate() - 1.0);
}

std::vector<reports::Study> studies() {
    using namespace term;
    const std::vector<std::string> covered{heat_storage,  heat_convection, heat_conduction,
                                           reaction_flux, pyrolysis,       surface_motion,
                                           slope,         grid_motion,     time_step};
    reports::Study columns("ripple");
    columns.refines("columns", {16, 32, 64})
        .measure([](int n) { return measure(0.1 * um, n, 1.0 / n); })
        .covers(covered)
        .gate(rate, Norm::magnitude, expect(2.0).within(0.3),
              "bilinear elements, third-order slopes, bdf2; the step with the cell")
        .bound(rate_off, 64, between(-0.01, 0.01), "four columns of 64 a layer");
    reports::Study amplitudes("ripple, its remainder");
    amplitudes.refines("amplitude [nm]", {8000, 4000, 2000, 1000})
        .measure([](int amplitude) { return measure(amplitude * 1e-3 * um, 64, amplitude); })
        .covers(covered)
        .difference_gate(rate, Norm::magnitude, expect(2.0).within(0.2),
                         "the truth is linear, and its next order odd in the amplitude");
    return {columns, amplitudes};
}

const Registered here{{.name = "ripple",
                       .figure = "-",
                       .shows = "ripple of a burning front against its exact decay",
                       .physics = {physics::burning},
                       .cost = {.verify = 3.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
