/// # Figure 13: temperature, pressure and strain in a burning pack
///
/// A random pack, 72 % discs of AP in binder, burns under 2 MPa; heat flows from the flame at
/// 200 cal/(s cm2) into AP and 160 into the binder. Four times, each in the laboratory: the discs
/// stand still and the surface comes down through them. Lines are the rims of the discs; the
/// solver knows of them what a cell's fraction of AP says (figure 12), less the deeper they are.
///
/// What to see: heat has gone some 100 um deep, and strain with it. Strain peaks in the
/// thin ligaments of binder between hot discs. What not to read off: the peaks. The largest strain
/// and pressure sit beside corners where stress is singular and grow with every refinement; the
/// mean over 5 um about the peak stays, and is given beside each.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/build_info.hpp"
#include "cases/paper/ledger/evidence.hpp"
#include "cases/paper/pack_maps.hpp"
#include "cases/paper/pack_movie.hpp"
#include "cases/registry.hpp"
#include "cases/scene_text.hpp"
#include "cases/scenes/pack.hpp"
#include "cases/scenes/sandwich_measures.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;

constexpr double below_surface = 120 * um;  // what is shown below the lowest point of all
constexpr double map_width = 180.0;         // of each of the four [points]
constexpr double gap = 14.0;                // between them
constexpr double left = 80.0, right = 105.0, foot = 95.0, head = 70.0;

/// What the claims ask for.
namespace finds {
constexpr auto times = "times that are shown";
constexpr auto in_binder = "of them with the peak of strain in binder";
}  // namespace finds

bool peaks_in_binder(const Snapshot& snapshot) {
    const auto& strain = snapshot.strain_norm.values();
    const auto k = std::ranges::max_element(strain) - strain.begin();
    return snapshot.material.values()[size_t(k)] < 0.5;
}

Outcome fig13(const Request& request) {
    const Scene scene = burning_pack(request.fidelity);
    const auto burn = kept_burn(scene, request);
    const double bottom = surface_span(burn->last).lowest - below_surface;

    Outcome outcome{reports::Figure("fig13", request.out), {}, {scene}};
    double largest_temperature = 0.0, largest_strain = 0.0;
    double lowest_pressure = 0.0, largest_pressure = 0.0;
    int number = 0, in_binder = 0;
    for (const Snapshot& snapshot : four_times(*burn)) {
        const std::string tag = std::to_string(++number);
        const Peak strain = peak(snapshot, snapshot.strain_norm, peak_radius);
        outcome.figure.map("nodes" + tag, node_maps(snapshot, bottom))
            .map("cells" + tag, cell_maps(snapshot, bottom))
            .table("surface" + tag, surface_line_of(snapshot))
            .table("rims" + tag, disc_rims(scene, snapshot, bottom))
            .set("time" + tag, fmt::format("t = {:g} ms", snapshot.time / ms));
        in_binder += peaks_in_binder(snapshot);
        const auto pressure = std::ranges::minmax(snapshot.pressure.values());
        lowest_pressure = std::min(lowest_pressure, pressure.min);
        largest_pressure = std::max(largest_pressure, pressure.max);
        largest_temperature =
            std::max(largest_temperature, std::ranges::max(snapshot.temperature.values()));
        largest_strain = std::max(largest_strain, strain.value);
        const std::string when = fmt::format("t = {:g} ms: ", snapshot.time / ms);
        outcome.findings.push_back(
            {when + "strain norm, mean over 5 um about the peak", strain.mean, "-"});
        outcome.findings.push_back({when + "strain norm, peak on this grid", strain.value, "-"});
    }

    outcome.findings.push_back({finds::times, double(number), "-"});
    outcome.findings.push_back({finds::in_binder, double(in_binder), "-"});

    const double height = map_width * -bottom / scene.domain.width;
    const double whole_width = left + 4.0 * map_width + right;
    const double whole_height = head + height + foot;
    outcome.figure.set("bottom", bottom / um)
        .set("width", scene.domain.width / um)
        .set("largest_temperature", largest_temperature)
        .set("largest_strain", largest_strain)
        .set("lowest_temperature", scene.bottom.temperature)
        .set("lowest_pressure", lowest_pressure / MPa)
        .set("largest_pressure", largest_pressure / MPa)
        .set("left_side", left / whole_width)
        .set("map_side", map_width / whole_width)
        .set("gap_side", gap / whole_width)
        .set("foot_side", foot / whole_height)
        .set("map_height", height / whole_height)
        .caption({.grid = grid_text(scene),
                  .step = step_text(scene),
                  .revision = revision(),
                  .note = "peaks of p and |E| depend on the grid"});
    for (const char* panel : {"a", "b", "c"})
        outcome.figure.panel(panel, reports::Format::png,
                             {.width = int(whole_width), .height = int(whole_height)});
    return outcome;
}

ledger::Rows claims(const ledger::Evidence& evidence) {
    const auto found = evidence.findings_of("fig13");
    const double times = found(finds::times), in_binder = found(finds::in_binder);
    return {reports::judged(reports::Statement{
        "peak strains occur in binder between AP particles", "Fig. 13c", "fig13",
        "in thin binder regions in between AP particles",
        fmt::format("the peak lies in binder at {:.0f} of {:.0f} times", in_binder, times),
        "at the four times of Fig. 13", in_binder == times,
        "By the volume fraction of the cell that holds it."})};
}

const Registered here{{.name = "fig13",
                       .figure = "Fig. 13",
                       .shows = "pack: maps of temperature, pressure, strain at four times",
                       .physics = {physics::heat, physics::burning, physics::stress,
                                   physics::coupling, physics::reference_map, physics::pack},
                       .cost = {.draft = 15.0, .paper = 400.0},
                       .draw = fig13,
                       .burns = [](Fidelity f) { return std::vector{burning_pack(f)}; },
                       .draw_movie = pack_movie,
                       .movie_burns = [](Fidelity f) { return std::vector{burning_pack(f)}; },
                       .claims = claims}};

}  // namespace

}  // namespace crawford
