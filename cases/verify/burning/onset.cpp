/// # Onset: from which heat of reaction on does a burning front swing ever more?
///
/// Where pyrolysis frees heat, a front that runs ahead meets cold solid, starves, and waits: it
/// swings. Linearised about the steady front that is an exact complex growth rate sigma
/// (reference/onset.hpp), which crosses zero at z Theta = (1 + sqrt(1 + 8 z))/2: for AP under 200
/// cal/(s cm2) at q_s = 0.458 MJ/kg. Its truth is a formula of heat, pyrolysis and motion
/// together, in time.
///
/// Three q_s: at the onset, where the front neither grows nor dies, and 3 % on either side. The
/// burn starts in the exact mode, once with the front a thousandth of the thermal layer too high and
/// once too low; half the difference is free of the steady state's own error and of everything of
/// even order in the amplitude, and what is of third order is 1e-6. Two periods are read by Prony's
/// method. The step, bdf2's, is a hundredth of a period on the finest grid and grows with the cell.

#include "reference/onset.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "cases/registry.hpp"
#include "cases/scenes/slab.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/burning/exact_start.hpp"
#include "cases/verify/burning/series.hpp"
#include "solver/run/loop.hpp"

namespace crawford {

namespace {

using namespace units;
using Complex = std::complex<double>;
using reports::at_least;
using reports::at_most;
using reports::expect;
using reports::Norm;

constexpr int finest = 192;
constexpr int steps_a_period = 100;  // on the finest grid
constexpr int periods = 2;
constexpr double height_in_layers = 1e-3;

Slab slab_of(int rows) {
    return slab("AP", {.cells = rows, .clustering = 2.0, .depth = 240.0 * um})
        .burning_by_law()
        .heated(200.0 * cal / (s * cm2))
        .rigid();
}

/// The half space: at 240 um the slab is 18 layers deep.
reference::SlabConditions conditions_of(double heat_of_reaction) {
    auto conditions = slab_of(1).conditions(reference::SlabModel::thermal);
    conditions.material.heat_of_reaction = heat_of_reaction;
    conditions.depth = std::numeric_limits<double>::infinity();
    return conditions;
}

/// r_b [m/s] after each step of a burn that starts with the front `height` [m] too high.
std::vector<double> rates(const Scene& scene, const reference::SlabConditions& conditions,
                          double height, int steps) {
    const reference::SwingingFront exact(conditions);
    const auto swing = [&](double t) { return height * std::exp(exact.growth_rate() * t); };
    Simulation simulation(scene);
    start_exactly(
        simulation,
        {.surface = [&](double, double t) { return swing(t).real() - exact.front().burn_rate * t; },
         .temperature =
             [&](double, double eta, double t) {
                 return exact.front().temperature(eta) + (exact.temperature(eta) * swing(t)).real();
             }});
    std::vector<double> rate{simulation.burn_rate().front()};
    run_steps(simulation, steps,
              {[&](Simulation& s, double) { rate.push_back(s.burn_rate().front()); }});
    return rate;
}

constexpr auto complex_rate = "sigma";
constexpr auto distance = "|sigma - exact|/|exact|";
constexpr auto growth = "growth/|exact|";

reports::Measurement measure(double of_onset, int rows) {
    const double onset = reference::heat_of_reaction_at_onset(conditions_of(0.0));
    const auto conditions = conditions_of(of_onset * onset);
    const reference::SwingingFront exact(conditions);
    const Complex sigma = exact.growth_rate();

    Scene scene = slab_of(rows).scene();
    scene.morphology.materials.front().heat_of_reaction = of_onset * onset;
    const int period = steps_a_period * rows / finest;
    scene.time.step = 2.0 * std::numbers::pi / (sigma.imag() * period);
    scene.time.scheme = Stepping::bdf2;

    const double height = height_in_layers / exact.front().wave_number();
    const auto above = rates(scene, conditions, height, periods * period);
    const auto below = rates(scene, conditions, -height, periods * period);
    std::vector<double> swing;
    for (size_t k = 0; k < above.size(); ++k) swing.push_back(0.5 * (above[k] - below[k]));
    const Complex found = swinging_growth(swing, scene.time.step, period / 8);
    return reports::Measurement(1.0 / rows)
        .error(complex_rate, Norm::magnitude, std::abs(found - sigma), std::abs(sigma))
        .value(distance, std::abs(found - sigma) / std::abs(sigma))
        .value(growth, found.real() / std::abs(sigma));
}

reports::Study study(const std::string& name, double of_onset) {
    using namespace term;
    reports::Study study("onset, " + name);
    study.refines("rows", {finest / 4, finest / 2, finest})
        .measure([of_onset](int rows) { return measure(of_onset, rows); })
        .covers({heat_storage, heat_convection, heat_conduction, reaction_flux, pyrolysis,
                 surface_motion, grid_motion, time_step})
        .gate(complex_rate, Norm::magnitude, expect(2.0).within(0.3),
              "centred differences and bdf2, the step with the cell")
        .bound(distance, finest, at_most(0.01), "1 % of |sigma|, a tenth of what 3 % of q_s do");
    return study;
}

std::vector<reports::Study> studies() {
    return {study("at it", 1.0),
            study("3 % below", 0.97).bound(growth, finest, at_most(0.0), "it must die"),
            study("3 % above", 1.03).bound(growth, finest, at_least(0.0), "it must grow")};
}

const Registered here{{.name = "onset",
                       .figure = "-",
                       .shows = "front that swings by its own heat, at the onset",
                       .physics = {physics::burning},
                       .cost = {.verify = 0.3},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
