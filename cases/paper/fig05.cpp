/// # Figure 5: the sandwich
///
/// The problem that figures 6 to 11 solve: a strip of binder between two blocks of AP, periodic in
/// x, heated and pressed on its burning surface, resting on rollers with one node pinned. The
/// window that is computed hangs below the surface and goes down with it.
///
/// Geometry and conditions are those of the scene; the surface is that of a run of 30 ms, long
/// enough for the flat surface to take its shape, short enough to show both windows. The bottom of
/// the present window has the shape of the surface, as the grid has. The paper prints its fluxes
/// per m2; per cm2 is the only reading under which the propellant burns.

#include <fmt/format.h>

#include <algorithm>

#include "base/build_info.hpp"
#include "cases/columns.hpp"
#include "cases/registry.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;

Scene begun(Fidelity fidelity) {
    Scene scene = burning_sandwich(fidelity, true);
    scene.time.end = 30.0 * ms;
    return scene;
}

Outcome fig05(const Request& request) {
    const Scene scene = begun(request.fidelity);
    const auto burn = kept_burn(scene, request);
    const SurfaceLine line = surface_line(burn->last);
    const double strip = std::get<Sandwich>(scene.morphology.shape).strip;
    const auto flux = [&](size_t material) {
        return scene.surface.heat_flux[material] / (cal / (s * cm2));
    };

    reports::Figure figure("fig05", request.out);
    figure.table("surface", {{"x", "um", scaled(line.x, um)}, {"y", "um", scaled(line.height, um)}})
        .set("width", scene.domain.width / um)
        .set("depth", scene.domain.depth / um)
        .set("strip", strip / um)
        .set("flux_AP", flux(0))
        .set("flux_binder", flux(1))
        .set("pressure", scene.surface.pressure / MPa)
        .set("bottom_temperature", scene.bottom.temperature)
        .set("time", scene.time.end / ms)
        .set("axis_height", line.height[line.height.size() / 2] / um)
        .caption({.grid = grid_text(scene), .step = step_text(scene), .revision = revision()})
        .panel(reports::Format::svg, {.width = 860, .height = 720});
    const auto [lowest, highest] = std::ranges::minmax(line.height);
    return {figure,
            {{"burnt at the highest point of the surface", -highest / um, "um"},
             {"burnt at the lowest point of the surface", -lowest / um, "um"},
             {"mean burn rate at the end", burn->mean_burn_rate.back() / (cm / s), "cm/s"}},
            {scene}};
}

const Registered here{{.name = "fig05",
                       .figure = "Fig. 5",
                       .shows = "sandwich: geometry, conditions, initial and present surface",
                       .physics = {physics::burning, physics::sandwich},
                       .cost = {.draft = 3.0, .paper = 20.0},
                       .draw = fig05,
                       .burns = [](Fidelity f) { return std::vector{begun(f)}; }}};

}  // namespace

}  // namespace crawford
