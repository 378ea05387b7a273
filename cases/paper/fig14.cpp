/// # Figure 14: what happens below the surface of a burning pack
///
/// The last of the four times of figure 13, close to the surface. Hot AP cannot expand sideways
/// and stands under pressure; the binder between is soft, carries little, and is strained instead.
/// Lines are the rims of the discs; every cell of pressure and strain is drawn as it is.
///
/// The largest values hang on the grid, because stress is singular where an interface meets the
/// surface; the mean over 5 um about each peak is given beside it.

#include <algorithm>
#include <cmath>

#include "base/build_info.hpp"
#include "cases/paper/pack_maps.hpp"
#include "cases/registry.hpp"
#include "cases/scene_text.hpp"
#include "cases/scenes/pack.hpp"
#include "cases/scenes/sandwich_measures.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;

constexpr double shown_below_surface = 70 * um;
constexpr double above_surface = 5 * um;
constexpr double map_width = 540.0;  // [points]
constexpr double left = 80.0, right = 145.0, foot = 90.0, head = 45.0;

Outcome fig14(const Request& request) {
    const Scene scene = burning_pack(request.fidelity);
    const auto burn = kept_burn(scene, request);
    const Snapshot& last = burn->last;
    const auto [lowest, highest] = surface_span(last);
    const double bottom = lowest - shown_below_surface;
    const Peak strain = peak(last, last.strain_norm, peak_radius);
    const Peak pressure = peak(last, last.pressure, peak_radius);

    const reports::QuadMap nodes = node_maps(last, bottom);
    const auto pressures = std::ranges::minmax(last.pressure.values());
    const auto temperature = std::ranges::minmax(nodes.fields.front().values);

    const double span = highest + above_surface - bottom;
    const double map_height = map_width * span / scene.domain.width;
    const double width = left + map_width + right, height = head + map_height + foot;
    reports::Figure figure("fig14", request.out);
    figure.map("nodes", nodes)
        .map("cells", cell_maps(last, bottom))
        .table("surface", surface_line_of(last))
        .table("rims", disc_rims(scene, last, bottom))
        .set("width", scene.domain.width / um)
        .set("bottom", bottom / um)
        .set("top", (highest + above_surface) / um)
        .set("left_side", left / width)
        .set("right_side", 1.0 - right / width)
        .set("foot_side", foot / height)
        .set("head_side", 1.0 - head / height)
        .set("lowest_temperature", temperature.min)
        .set("largest_temperature", temperature.max)
        .set("largest_strain", strain.value)
        .set("lowest_pressure", pressures.min / MPa)
        .set("largest_pressure", pressures.max / MPa)
        .caption({.grid = grid_text(scene),
                  .step = step_text(scene),
                  .revision = revision(),
                  .note = "peaks of p and |E| depend on the grid"});
    for (const char* panel : {"a", "b", "c"})
        figure.panel(panel, reports::Format::png, {.width = int(width), .height = int(height)});
    return {figure,
            {{"largest temperature", burn->largest_temperature.back(), "K"},
             {"strain norm, mean over 5 um about the peak", strain.mean, "-"},
             {"strain norm, peak on this grid", strain.value, "-"},
             {"pressure, mean over 5 um about the peak", pressure.mean / MPa, "MPa"},
             {"pressure, peak on this grid", pressure.value / MPa, "MPa"}},
            {scene}};
}

const Registered here{{.name = "fig14",
                       .figure = "Fig. 14",
                       .shows = "pack: temperature, pressure, strain near the surface",
                       .physics = {physics::heat, physics::burning, physics::stress,
                                   physics::coupling, physics::reference_map, physics::pack},
                       .cost = {.draft = 12.0, .paper = 400.0},
                       .draw = fig14,
                       .burns = [](Fidelity f) { return std::vector{burning_pack(f)}; }}};

}  // namespace

}  // namespace crawford
