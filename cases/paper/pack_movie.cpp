#include "cases/paper/pack_movie.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/build_info.hpp"
#include "cases/paper/pack_maps.hpp"
#include "cases/scene_text.hpp"
#include "cases/scenes/pack.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;

constexpr double frame_interval = filmed_every;
constexpr double below_surface = 100 * um;  // what is shown below the lowest point of all
constexpr double map_width = 200.0;         // [points]
constexpr double left = 95.0, pitch = 300.0, foot = 80.0, head = 60.0;

void add_frame(reports::Figure& figure, const Scene& scene, const Snapshot& snapshot, int number,
               double bottom) {
    const std::string tag = std::to_string(number);
    figure.map("nodes" + tag, node_maps(snapshot, bottom))
        .map("cells" + tag, cell_maps(snapshot, bottom))
        .table("surface" + tag, surface_line_of(snapshot))
        .table("rims" + tag, disc_rims(scene, snapshot, bottom))
        .set("time" + tag, snapshot.time / ms);
}

}  // namespace

Outcome pack_movie(const Request& request) {
    const Scene scene = burning_pack(request.fidelity);
    const auto burn = kept_burn(scene, request);
    const double bottom = surface_span(burn->last).lowest - below_surface;

    Outcome outcome{reports::Figure("fig13", request.out), {}, {scene}};
    outcome.figure.forget_numbers();
    const int frames = int(std::lround(scene.time.end / frame_interval));
    for (int k = 1; k <= frames; ++k)
        add_frame(outcome.figure, scene, burn->at(k * frame_interval), k, bottom);

    const double height = map_width * -bottom / scene.domain.width;
    const double whole_width = left + 2.0 * pitch + 15.0, whole_height = head + height + foot;
    outcome.figure.set("frames", double(frames))
        .set("bottom", bottom / um)
        .set("width", scene.domain.width / um)
        .set("lowest_temperature", scene.bottom.temperature)
        .set("largest_temperature", std::ranges::max(burn->largest_temperature))
        .set("largest_strain", std::ranges::max(burn->strain_about_peak))
        .set("left_side", left / whole_width)
        .set("map_side", map_width / whole_width)
        .set("pitch", pitch / whole_width)
        .set("foot_side", foot / whole_height)
        .set("head_side", 1.0 - head / whole_height)
        .caption({.grid = grid_text(scene),
                  .step = fmt::format("{:g} µs", scene.time.step / us),
                  .revision = revision()})
        .panel(reports::Format::gif, {.width = int(whole_width), .height = int(whole_height)});
    outcome.findings = {{"frames", double(frames), "-"},
                        {"time between frames", frame_interval / ms, "ms"}};
    return outcome;
}

}  // namespace crawford
