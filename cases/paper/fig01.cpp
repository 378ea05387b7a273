/// # Figure 1: the staggered grid
///
/// Where the unknowns live. Temperature, velocity and reference map stand at the nodes; stress,
/// deformation gradient and strain in the cells. The computational grid (a) is uniform. Clustering
/// (paper eq. 32) packs its rows at the surface and the shift eta = y - phi(x, t) hangs them below
/// it (b), so that every cell is a parallelogram with two vertical sides (c).
///
/// The lines are those of the solver's own grid, drawn so coarse that cells can be told apart: no
/// fidelity draws it finer. With clustering 2 a cell at the surface is a quarter as high as
/// without, and one at the bottom almost five times as high.

#include <fmt/format.h>

#include "base/build_info.hpp"
#include "cases/paper/ledger/evidence.hpp"
#include "cases/paper/wavy_grid.hpp"
#include "cases/registry.hpp"
#include "cases/scenes/pack.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/units.hpp"
#include "solver/mesh/cell.hpp"

namespace crawford {

namespace {

using namespace units;

constexpr Domain domain{.width = 240 * um, .depth = 480 * um, .nx = 16, .ny = 24, .clustering = 2};
constexpr double amplitude = 30.0 * um;

/// The nodes from side to side, as corners of the cells.
reports::QuadMap lines(const Grid& grid, const SurfaceField& surface, bool mapped) {
    reports::QuadMap map{.columns = size_t(grid.cell_columns()),
                         .rows = size_t(grid.rows()),
                         .x = {"x", "um", {}},
                         .y = {mapped ? "y" : "etahat", "um", {}},
                         .fields = {{"height of the cell", "um", {}}}};
    for (int j = 0; j <= grid.rows(); ++j)
        for (int i = 0; i <= grid.cell_columns(); ++i) {
            const Vector node = place(grid, surface, i, j);
            const double uniform = grid.depth() * (double(j) / grid.rows() - 1.0);
            map.x.values.push_back(node.x() / um);
            map.y.values.push_back((mapped ? node.y() : uniform) / um);
        }
    for (int j = 0; j < grid.rows(); ++j)
        for (int i = 0; i < grid.cell_columns(); ++i)
            map.fields.front().values.push_back(
                (mapped ? grid.height(j) : grid.depth() / grid.rows()) / um);
    return map;
}

/// The sides of the columns of cells below the surface, from the bottom up.
void add_sides(reports::Figure& figure, const Grid& grid, const SurfaceField& surface) {
    std::vector<double> x, bottom, top;
    for (int i = 0; i <= grid.cell_columns(); ++i) {
        x.push_back(grid.x(i) / um);
        bottom.push_back(place(grid, surface, i, 0).y() / um);
        top.push_back(place(grid, surface, i, grid.rows()).y() / um);
    }
    figure.table("sides", {{"x", "um", x}, {"y at the bottom", "um", bottom}, {"y", "um", top}});
}

void add_points(reports::Figure& figure, const Grid& grid, const SurfaceField& surface) {
    std::vector<double> node_x, node_y, centre_x, centre_y;
    for (int i = 0; i <= grid.cell_columns(); ++i)
        for (int j = 0; j <= grid.rows(); ++j) {
            const Vector node = place(grid, surface, i, j);
            node_x.push_back(node.x() / um);
            node_y.push_back(node.y() / um);
        }
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j) {
            const Cell cell(grid, surface, i, j);
            centre_x.push_back((grid.x(i) + 0.5 * cell.dx) / um);
            centre_y.push_back((surface[size_t(i)] + 0.5 * cell.slope * cell.dx + grid.eta(j) +
                                0.5 * cell.height) /
                               um);
        }
    figure.table("nodes", {{"x", "um", node_x}, {"y", "um", node_y}})
        .table("centres", {{"x", "um", centre_x}, {"y", "um", centre_y}});
}

Outcome fig01(const Request& request) {
    const Grid grid(domain);
    const SurfaceField surface = wave(grid, amplitude);
    reports::Figure figure("fig01", request.out);
    figure.map("uniform", lines(grid, surface, false))
        .map("mapped", lines(grid, surface, true))
        .caption(
            {.grid = fmt::format("{} × {}, clustering {}", domain.nx, domain.ny, domain.clustering),
             .revision = revision()})
        .set("width", domain.width / um)
        .set("depth", domain.depth / um)
        .set("amplitude", amplitude / um)
        .set("rows", double(domain.ny))
        .panel("a", reports::Format::svg, {.width = 340, .height = 600})
        .panel("b", reports::Format::svg, {.width = 340, .height = 600})
        .panel("c", reports::Format::svg, {.width = 540, .height = 600});
    add_sides(figure, grid, surface);
    add_points(figure, grid, surface);
    Scene scene;
    scene.title = "the grid of figure 1";
    scene.domain = domain;
    return {figure,
            {{"height of the cells at the surface", grid.height(grid.rows() - 1) / um, "um"},
             {"height of the cells at the bottom", grid.height(0) / um, "um"},
             {"depth/ny", grid.depth() / grid.rows() / um, "um"}},
            {scene}};
}

/// Height of the cells at the surface of a scene [um].
double finest_cell(const Scene& scene) {
    const Grid grid(scene.domain);
    return grid.height(grid.rows() - 1) / um;
}

ledger::Rows claims(const ledger::Evidence&) {
    using namespace reports;
    return {judged({"finest cell of the sandwich's grid", "sec. 5.1", "fig01", "um", "1.25", 1.25,
                    half_digit("1.25")},
                   {finest_cell(burning_sandwich(Fidelity::paper, true)),
                    ledger::exact,
                    "eq. 32, c = 2, 96 rows over 480 um",
                    {},
                    {},
                    "{:.3f}"}),
            judged({"finest cell of the pack's grid", "sec. 5.2", "fig01", "um", "2", 2.0,
                    half_digit("2")},
                   {finest_cell(burning_pack(Fidelity::paper)),
                    ledger::exact,
                    "eq. 32, c = 2, 96 rows over 720 um",
                    {},
                    {},
                    "{:.3f}"})};
}

const Registered here{{.name = "fig01",
                       .figure = "Fig. 1",
                       .shows = "the staggered grid below a sloped surface",
                       .physics = {physics::grid},
                       .cost = {.draft = 0.3, .paper = 0.3},
                       .draw = fig01,
                       .claims = claims}};

}  // namespace

}  // namespace crawford
