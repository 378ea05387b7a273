/// # Figure 17: the pack under twice the heat
///
/// The pack of figure 13 burns under the flux of its flame, Q, and under twice as much, 400 cal/(s
/// cm2) into AP and 320 into the binder: burn rate averaged over the surface, and largest strain
/// norm. Dotted lines are means from 20 ms on, where they begin.
///
/// Twice the flux burns a little less than twice as fast: the surface grows hotter, and heating to
/// it takes more. Strain grows with the temperature of the binder. The largest strain depends on
/// the grid; the mean over 5 um about it, given beside, is what to compare. Both burn the same time
/// and so not the same depth of the pack.

#include <string>

#include "base/build_info.hpp"
#include "cases/columns.hpp"
#include "cases/registry.hpp"
#include "cases/scene_text.hpp"
#include "cases/scenes/pack.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;

/// Returns the mean burn rate [m/s].
double add(Outcome& outcome, const std::string& name, const Burn& burn) {
    const Course rate = course(burn.time, burn.mean_burn_rate);
    const Course strain = course(burn.time, burn.largest_strain);
    const Course about_peak = course(burn.time, burn.strain_about_peak);
    outcome.figure
        .table(name, {{"t", "ms", scaled(burn.time, ms)},
                      {"mean r_b", "cm/s", scaled(burn.mean_burn_rate, cm / s)},
                      {"largest strain norm", "-", burn.largest_strain}})
        .set("rate_" + name, rate.mean / (cm / s))
        .set("strain_" + name, strain.mean);
    const auto find = [&](const std::string& what, double value, const std::string& unit) {
        outcome.findings.push_back({name + ": " + what, value, unit});
    };
    find("mean burn rate, mean from 20 ms on", rate.mean / (cm / s), "cm/s");
    find("mean burn rate, standard deviation in time", rate.deviation / (cm / s), "cm/s");
    find("largest strain norm on this grid, mean from 20 ms on", strain.mean, "-");
    find("largest strain norm on this grid, deviation in time", strain.deviation, "-");
    find("strain norm over 5 um about the peak, mean", about_peak.mean, "-");
    outcome.scenes.push_back(burn.scene);
    return rate.mean;
}

Outcome fig17(const Request& request) {
    const Scene scene = burning_pack(request.fidelity);
    Outcome outcome{reports::Figure("fig17", request.out, "cases/paper/fig17.gp"), {}, {}};
    const double once = add(outcome, "Q", *kept_burn(scene, request));
    const double twice =
        add(outcome, "2Q", *kept_burn(burning_pack(request.fidelity, {.flux = 2.0}), request));
    outcome.findings.push_back({"mean burn rate, 2Q over Q", twice / once, "-"});
    outcome.figure.set("since", burning_since / ms)
        .set("until", scene.time.end / ms)
        .caption({.grid = grid_text(scene),
                  .step = step_text(scene),
                  .revision = revision(),
                  .note = "dotted: mean from 20 ms on; the largest |E| depends on the grid"});
    for (const char* panel : {"a", "b"})
        outcome.figure.panel(panel, reports::Format::svg, {.width = 760, .height = 400});
    return outcome;
}

const Registered here{{.name = "fig17",
                       .figure = "Fig. 17",
                       .shows = "pack: burn rate and largest strain under once and twice the flux",
                       .physics = {physics::burning, physics::reference_map, physics::pack},
                       .cost = {.draft = 18.0, .paper = 410.0},
                       .draw = fig17,
                       .burns = [](Fidelity f) {
                           return std::vector{burning_pack(f), burning_pack(f, {.flux = 2.0})};
                       }}};

}  // namespace

}  // namespace crawford
