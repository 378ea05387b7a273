/// # Figure 16: the largest strain in a burning pack
///
/// The largest strain norm of the pack of figure 13 at every step, and the mean over 5 um about it
/// every 0.5 ms; dotted lines are their means from 20 ms on, where they begin.
///
/// Stress is singular where the edge of a disc meets the surface, so the largest strain is a number
/// of the grid as much as of the pack: it grows with every refinement. The mean over a fixed radius
/// does converge and is the one to compare. (The disc about a peak is cut at the periodic sides.)

#include "base/build_info.hpp"
#include "cases/columns.hpp"
#include "cases/paper/ledger/pack_evidence.hpp"
#include "cases/paper/ledger/readings.hpp"
#include "cases/registry.hpp"
#include "cases/scene_text.hpp"
#include "cases/scenes/pack.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;

Outcome fig16(const Request& request) {
    const Scene scene = burning_pack(request.fidelity);
    const auto burn = kept_burn(scene, request);
    const Course largest = course(burn->time, burn->largest_strain);
    const Course about_peak = course(burn->time, burn->strain_about_peak);

    reports::Figure figure("fig16", request.out);
    figure
        .table("largest", {{"t", "ms", scaled(burn->time, ms)},
                           {"largest strain norm", "-", burn->largest_strain}})
        .table("about_peak", {{"t", "ms", scaled(burn->time, ms)},
                              {"strain norm about the peak", "-", burn->strain_about_peak}})
        .set("mean_largest", largest.mean)
        .set("mean_about_peak", about_peak.mean)
        .set("since", burning_since / ms)
        .set("until", scene.time.end / ms)
        .caption({.grid = grid_text(scene),
                  .step = step_text(scene),
                  .revision = revision(),
                  .note = "dotted: mean from 20 ms on; the largest depends on the grid"});
    return {figure,
            {{"largest strain norm on this grid, mean from 20 ms on", largest.mean, "-"},
             {"largest strain norm on this grid, deviation in time", largest.deviation, "-"},
             {"mean over 5 um about the peak, mean from 20 ms on", about_peak.mean, "-"},
             {"mean over 5 um about the peak, deviation in time", about_peak.deviation, "-"},
             finding(ledger::mean_strain, *burn),
             finding(ledger::mean_strain_about_peak, *burn)},
            {scene}};
}

ledger::Rows claims(const ledger::Evidence& evidence) {
    using namespace ledger;
    const auto found = evidence.findings_of("fig16");
    return {judged({"mean of the largest strain", "Fig. 16", "fig16", "%", "31.6", 31.6,
                    reports::half_digit("31.6")},
                   {found(mean_strain.what), found(mean_strain_about_peak.what),
                    divergence(evidence, of_pack, mean_strain, "x and y"),
                    times(others(evidence.pack_readings, quantity::largest_strain), 100.0)},
                   uncertainty_of_peak(evidence, of_pack))};
}

const Registered here{{.name = "fig16",
                       .figure = "Fig. 16",
                       .shows = "pack: largest strain against time",
                       .physics = {physics::reference_map, physics::pack},
                       .cost = {.draft = 12.0, .paper = 400.0},
                       .draw = fig16,
                       .burns = [](Fidelity f) { return std::vector{burning_pack(f)}; },
                       .claims = claims,
                       .claims_rest_on = LedgerRuns::pack}};

}  // namespace

}  // namespace crawford
