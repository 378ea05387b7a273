/// # Presets: does each keep its promise?
///
/// `crawford burn --accuracy "1 %"` chooses grid and steps in the scene's own measures: rows in a
/// thermal layer, columns in a strip or disc, steps by their error (docs/trade.md). The promise is of
/// V, and must carry over: here to fluxes from 0.7 to 2 times the paper's, where the exact solution
/// of the rigid sandwich (the free-boundary problem) and of the slab with stress are known. A
/// sandwich and a pack with stress have none: they are held against a finer preset, whose own promise
/// is a part of the bound.

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/source_tree.hpp"
#include "cases/registry.hpp"
#include "cases/scenes/slab.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "reference/burning_sandwich_front.hpp"
#include "reference/slab.hpp"
#include "solver/run/loop.hpp"
#include "solver/run/preset.hpp"
#include "solver/scene/read_scene.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::between;
using reports::Measurement;

constexpr auto rate_error = "V, error";
constexpr double part = 0.01;  ///< of a flux given in % of the paper's

Preset preset(const std::string& name) {
    return read_preset(source_path("cases/scenes/presets/" + name + ".toml"));
}

/// The scene of a file as a preset burns it.
Scene chosen_scene(const std::string& file, std::vector<std::string> changes,
                   const std::string& name) {
    const auto path = source_path("cases/scenes/" + file);
    const Chosen chosen = choose(preset(name), read_scene(path, changes));
    changes.insert(changes.end(), chosen.keys.begin(), chosen.keys.end());
    return read_scene(path, changes);
}

/// Mean drop of the surface per time from `from` to the end [m/s].
double regression_rate(const Scene& scene, double from) {
    Simulation simulation(scene);
    double drop = 0.0, time = 0.0;
    run_to_end(simulation, {[&](Simulation& now, double before) {
                   if (before < from) return;
                   const double length = now.state().time - before;
                   drop += length * now.summary().regression_rate;
                   time += length;
               }});
    return drop / time;
}

std::string fluxes(double percent) {
    return fmt::format("surface.heat_flux={{AP=\"{} cal/(s cm2)\", binder=\"{} cal/(s cm2)\"}}",
                       200.0 * part * percent, 160.0 * part * percent);
}

const std::vector<std::string> rigid{"physics.mechanics=false", "physics.reference_map=false"};

/// A layer relaxes over 4 D/r_b^2: with the flux the time until a burn is steady falls as its square.
double until_steady(double of_the_papers_flux, int percent) {
    return of_the_papers_flux / std::pow(part * percent, 2);
}

Measurement rigid_sandwich(const std::string& name, int percent) {
    const double end = until_steady(160.0 * ms, percent);
    std::vector<std::string> changes{"time.until_steady=", fmt::format("time.end={} s", end),
                                     fluxes(percent)};
    changes.insert(changes.end(), rigid.begin(), rigid.end());
    auto flame = reference::paper_flame();
    flame.inner_flux *= part * percent;
    flame.outer_flux *= part * percent;
    const reference::BurningSandwichFront exact(reference::paper_sandwich(), flame);
    const double found = regression_rate(chosen_scene("sandwich.toml", changes, name), 0.75 * end);
    return Measurement(1.0).value(rate_error, found / exact.regression_rate() - 1.0);
}

Measurement slab_with_stress(const std::string& name, int percent) {
    const double flux = 200.0 * part * percent * cal / (s * cm2);
    const reference::Slab exact(slab("AP", {.cells = 1})
                                    .burning_by_law()
                                    .heated(flux)
                                    .pressed(2.0 * MPa)
                                    .conditions(reference::SlabModel::eulerian));
    const double end = until_steady(0.2 * s, percent);
    const Scene scene = chosen_scene(
        "slab.toml",
        {fmt::format("time.end={} s", end), "physics.regression=pyrolysis",
         "materials.AP.heat_of_reaction=", fmt::format("surface.heat_flux={} W/m2", flux)},
        name);
    return Measurement(1.0).value(rate_error,
                                  regression_rate(scene, 0.9 * end) / exact.burn_rate() - 1.0);
}

reports::Study of(const std::string& name, const std::string& of_what,
                  Measurement (*measure)(const std::string&, int), const std::vector<int>& percents,
                  const std::vector<std::string>& terms) {
    const double promised = preset(name).error;
    reports::Study study(fmt::format("presets, {}, {}", name, of_what));
    study.refines("flux_percent", percents)
        .measure([=](int percent) { return measure(name, percent); })
        .covers(terms);
    for (const int percent : percents)
        study.bound(rate_error, percent, between(-promised, promised), "what the preset promises");
    return study;
}

/// Scenes with stress, each preset against the next finer one.
reports::Study against_a_finer(const std::string& of_what, const std::string& file,
                               const std::vector<std::string>& changes, double from,
                               const std::string& finer, const std::vector<std::string>& names) {
    reports::Study study("presets, " + of_what);
    study.refines("flux_percent", {100})
        .measure([=](int) {
            const double truth = regression_rate(chosen_scene(file, changes, finer), from);
            Measurement found(1.0);
            for (const std::string& name : names)
                found.value(name + ", V, error",
                            regression_rate(chosen_scene(file, changes, name), from) / truth - 1.0);
            return found;
        })
        .covers({term::surface_motion, term::pyrolysis, term::stress_work});
    for (const std::string& name : names) {
        const double most = preset(name).error + preset(finer).error;
        study.bound(name + ", V, error", 100, between(-most, most),
                    "what the preset promises, and what the finer one does");
    }
    return study;
}

std::vector<reports::Study> studies() {
    const std::vector<std::string> heat{term::heat_conduction, term::heat_convection,
                                        term::surface_motion,  term::pyrolysis,
                                        term::gas_flux,        term::reaction_flux};
    std::vector<reports::Study> all;
    for (const char* name : {"draft", "paper"})
        all.push_back(of(name, "rigid sandwich", rigid_sandwich, {70, 100, 200}, heat));
    all.push_back(of("fine", "rigid sandwich", rigid_sandwich, {100}, heat));
    for (const char* name : {"draft", "paper", "fine"})
        all.push_back(of(name, "slab", slab_with_stress, {50, 100, 200}, heat));
    all.push_back(against_a_finer("sandwich", "sandwich.toml",
                                  {"time.until_steady=", "time.end=60 ms"}, 40.0 * ms, "fine",
                                  {"draft", "paper"}));
    all.push_back(
        against_a_finer("pack", "pack.toml", {"time.end=30 ms"}, 10.0 * ms, "paper", {"draft"}));
    return all;
}

const Registered here{{.name = "presets",
                       .figure = "-",
                       .shows = "each preset of burn --accuracy against its promise",
                       .cost = {.verify = 60.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
