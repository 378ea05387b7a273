/// # Figure 12: the random pack
///
/// 40 discs of AP of three radii, packed at random in binder, periodic both ways: left as they are,
/// right as the grid of the burning sees them, by the volume fraction of AP in each cell.
///
/// The paper calls 38.4, 28.8 and 17.7 um diameters. As diameters 40 discs would cover 19 % of the
/// box; as radii they cover its 72 % in a box 774 um high. The burning window, 720 um deep, begins
/// at y = 0 and, as it goes down, meets the pack again below its lower edge.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/build_info.hpp"
#include "base/source_tree.hpp"
#include "cases/paper/ledger/evidence.hpp"
#include "cases/registry.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/units.hpp"
#include "solver/materials/material_map.hpp"
#include "solver/scene/read_scene.hpp"

namespace crawford {

namespace {

using namespace units;

Scene pack(Fidelity fidelity) {
    Scene scene = read_scene(source_path("cases/scenes/pack.toml"));
    if (fidelity == Fidelity::draft) scene.domain.nx = scene.domain.ny = 60;
    if (fidelity == Fidelity::fine) scene.domain.nx = 240;
    return scene;
}

/// Distance to the nearest integer multiple of a period, with its sign.
double nearest(double distance, double period) {
    return distance - period * std::round(distance / period);
}

/// Smallest distance between the rims of two discs, images included [m].
double smallest_gap(const Discs& discs, double width) {
    double gap = width;
    for (size_t a = 0; a < discs.discs.size(); ++a)
        for (size_t b = 0; b < a; ++b) {
            const Disc& p = discs.discs[a];
            const Disc& q = discs.discs[b];
            gap = std::min(gap,
                           std::hypot(nearest(p.x - q.x, width), nearest(p.y - q.y, discs.period)) -
                               p.radius - q.radius);
        }
    return gap;
}

/// Every disc and its images that reach into the box, in the grid's x and y in (-period, 0].
void add_discs(reports::Figure& figure, const Discs& discs, double width) {
    std::vector<double> x, y, radius;
    for (const Disc& disc : discs.discs) {
        const double middle_x = nearest(disc.x, width);
        const double middle_y = disc.y - discs.period * std::ceil(disc.y / discs.period);
        for (const double across : {-width, 0.0, width})
            for (const double down : {-discs.period, 0.0, discs.period}) {
                const double image_x = middle_x + across, image_y = middle_y + down;
                const bool reaches = std::abs(image_x) < 0.5 * width + disc.radius &&
                                     image_y < disc.radius && image_y > -discs.period - disc.radius;
                if (!reaches) continue;
                x.push_back(image_x / um);
                y.push_back(image_y / um);
                radius.push_back(disc.radius / um);
            }
    }
    figure.table("discs", {{"x", "um", x}, {"y", "um", y}, {"radius", "um", radius}});
}

reports::QuadMap fraction_map(const Scene& scene) {
    const Grid grid(scene.domain);
    MaterialMap materials(scene.morphology, grid);
    materials.follow(SurfaceField(size_t(grid.node_columns()), 0.0));
    reports::QuadMap map{.columns = size_t(grid.cell_columns()),
                         .rows = size_t(grid.rows()),
                         .x = {"x", "um", {}},
                         .y = {"y", "um", {}},
                         .fields = {{"fraction of AP", "-", {}}}};
    for (int j = 0; j <= grid.rows(); ++j)
        for (int i = 0; i <= grid.cell_columns(); ++i) {
            map.x.values.push_back(grid.x(i) / um);
            map.y.values.push_back(grid.eta(j) / um);
        }
    for (int j = 0; j < grid.rows(); ++j)
        for (int i = 0; i < grid.cell_columns(); ++i)
            map.fields.front().values.push_back(materials.fraction()(i, j));
    return map;
}

constexpr double map_width = 210.0;  // [points]
constexpr double left = 80.0, right = 115.0, foot = 95.0, head = 75.0;

/// What the claims ask for.
namespace finds {
constexpr auto area_fraction = "area fraction of AP";
std::string discs(double radius) {
    return fmt::format("discs of radius {:.1f} um", radius / um);
}
}  // namespace finds

Outcome fig12(const Request& request) {
    const Scene scene = pack(request.fidelity);
    const auto& discs = std::get<Discs>(scene.morphology.shape);
    const double width = scene.domain.width;
    double area = 0.0;
    std::map<double, int, std::greater<>> sizes;
    for (const Disc& disc : discs.discs) {
        area += std::numbers::pi * disc.radius * disc.radius;
        ++sizes[disc.radius];
    }
    const double fraction = area / (width * discs.period);
    const double gap = smallest_gap(discs, width);

    const double map_height = map_width * discs.period / width;
    const reports::PanelSize panel_size{.width = int(left + map_width + right),
                                        .height = int(foot + map_height + head)};

    reports::Figure figure("fig12", request.out);
    add_discs(figure, discs, width);
    figure.map("fraction", fraction_map(scene))
        .set("width", width / um)
        .set("count", double(discs.discs.size()))
        .set("largest_radius", sizes.begin()->first / um)
        .set("smallest_radius", sizes.rbegin()->first / um)
        .set("period", discs.period / um)
        .set("depth", scene.domain.depth / um)
        .caption({.grid = grid_text(scene),
                  .revision = revision(),
                  .note = fmt::format("{:.1f} % AP", 100.0 * fraction)})
        .set("left_side", left / panel_size.width)
        .set("right_side", (left + map_width) / panel_size.width)
        .set("foot_side", foot / panel_size.height)
        .set("head_side", (foot + map_height) / panel_size.height)
        .panel("a", reports::Format::svg, panel_size)
        .panel("b", reports::Format::png, panel_size);
    Outcome outcome{figure,
                    {{finds::area_fraction, fraction, "-"},
                     {"smallest gap between discs", gap / um, "um"},
                     {"width of a cell", width / scene.domain.nx / um, "um"}},
                    {scene}};
    for (const auto& [radius, count] : sizes)
        outcome.findings.push_back({finds::discs(radius), double(count), "-"});
    return outcome;
}

ledger::Rows claims(const ledger::Evidence& evidence) {
    using namespace reports;
    const auto found = evidence.findings_of("fig12");
    double discs = 0.0;
    for (const double radius : {38.4 * um, 28.8 * um, 17.7 * um})
        discs += found(finds::discs(radius));
    return {judged({"discs of the pack", "Fig. 12", "fig12", "-", "40", 40.0, 0.0},
                   {discs, ledger::exact, "printed diameters are radii", {}, {}, "{:.0f}"}),
            judged({"area fraction of AP", "Fig. 12", "fig12", "%", "72", 72.0, half_digit("72")},
                   {100.0 * found(finds::area_fraction),
                    ledger::exact,
                    "printed diameters are radii, period 774.4 um",
                    {},
                    "As diameters 40 discs cover 19.4 % of the window.",
                    "{:.3f}"})};
}

const Registered here{{.name = "fig12",
                       .figure = "Fig. 12",
                       .shows = "the random pack, and as the grid sees it",
                       .physics = {physics::morphology, physics::pack},
                       .cost = {.draft = 0.5, .paper = 0.8},
                       .draw = fig12,
                       .claims = claims}};

}  // namespace

}  // namespace crawford
