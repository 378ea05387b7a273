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

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/build_info.hpp"
#include "cases/columns.hpp"
#include "cases/paper/ledger/pack_evidence.hpp"
#include "cases/registry.hpp"
#include "cases/scene_text.hpp"
#include "cases/scenes/pack.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;

constexpr auto once_the_flux = "Q", twice_the_flux = "2Q";

/// What the claims ask for, of each run, besides measures.
namespace finds {
constexpr auto later_burn_rate = "mean burn rate, mean from 20 ms on";
constexpr auto highest_strain = "largest strain norm on this grid at any time";
std::string of(const std::string& run, const std::string& what) {
    return run + ": " + what;
}
std::string of_whole(const std::string& run) {
    return of(run, "whole run, ");
}
}  // namespace finds

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
        outcome.findings.push_back({finds::of(name, what), value, unit});
    };
    find(finds::later_burn_rate, rate.mean / (cm / s), "cm/s");
    find("mean burn rate, standard deviation in time", rate.deviation / (cm / s), "cm/s");
    find("largest strain norm on this grid, mean from 20 ms on", strain.mean, "-");
    find("largest strain norm on this grid, deviation in time", strain.deviation, "-");
    find("strain norm over 5 um about the peak, mean", about_peak.mean, "-");
    find(finds::highest_strain, std::ranges::max(burn.largest_strain), "-");
    for (const ledger::Measure& measure :
         {ledger::mean_burn_rate_of_all, ledger::regression_rate_of_all, ledger::mean_strain,
          ledger::mean_strain_about_peak})
        outcome.findings.push_back(finding(measure, burn, finds::of_whole(name)));
    outcome.scenes.push_back(burn.scene);
    return rate.mean;
}

Outcome fig17(const Request& request) {
    const Scene scene = burning_pack(request.fidelity);
    Outcome outcome{reports::Figure("fig17", request.out), {}, {}};
    const double once = add(outcome, once_the_flux, *kept_burn(scene, request));
    const double twice = add(outcome, twice_the_flux,
                             *kept_burn(burning_pack(request.fidelity, {.flux = 2.0}), request));
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

ledger::Rows claims(const ledger::Evidence& evidence) {
    using namespace ledger;
    using reports::half_digit;
    const auto found = evidence.findings_of("fig17");
    const auto of_run = [&](const char* run, const Measure& measure) {
        return found(finds::of_whole(run) + measure.what);
    };
    const double once = of_run(once_the_flux, mean_strain);
    const double twice = of_run(twice_the_flux, mean_strain);
    return {
        reports::judged(
            {"mean burn rate, 2Q", "Fig. 17a", "fig17", "cm/s", "0.81", 0.81, half_digit("0.81")},
            {of_run(twice_the_flux, mean_burn_rate_of_all),
             uncertainty(evidence, of_pack_2Q, mean_burn_rate_of_all),
             pack_as_read,
             {{since_20_ms, found(finds::of(twice_the_flux, finds::later_burn_rate))}},
             fmt::format("Over the arc; the regression rate is {:.4f}.",
                         of_run(twice_the_flux, regression_rate_of_all)),
             "{:.4f}"}),
        judged({"mean of the largest strain, 2Q", "Fig. 17b", "fig17", "%", "37.24", 37.24,
                half_digit("37.24")},
               {twice, of_run(twice_the_flux, mean_strain_about_peak)},
               uncertainty_of_peak(evidence, of_pack_2Q)),
        reports::judged(
            {"highest peak of strain, 2Q", "Fig. 17b", "fig17", "%", "as high as 60", 60.0, 5.0},
            {percent(found(finds::of(twice_the_flux, finds::highest_strain))),
             {},
             "3 alpha K, c_p; this grid",
             {},
             "A single cell at a single time.",
             "{:.0f}"}),
        reports::judged(reports::Statement{
            "doubled flux raises the mean of the largest strain", "Fig. 17b", "fig17",
            "31.6 % to 37.24 %", fmt::format("{:.1f} % to {:.1f} %", percent(once), percent(twice)),
            pack_as_read, twice > once, "Two runs of one pack on one grid."})};
}

const Registered here{{.name = "fig17",
                       .figure = "Fig. 17",
                       .shows = "pack: burn rate and largest strain under once and twice the flux",
                       .physics = {physics::burning, physics::reference_map, physics::pack},
                       .cost = {.draft = 18.0, .paper = 410.0},
                       .draw = fig17,
                       .burns =
                           [](Fidelity f) {
                               return std::vector{burning_pack(f), burning_pack(f, {.flux = 2.0})};
                           },
                       .claims = claims,
                       .claims_rest_on = LedgerRuns::pack}};

}  // namespace

}  // namespace crawford
