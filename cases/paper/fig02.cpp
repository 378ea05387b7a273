/// # Figure 2: one hat function and what it couples
///
/// The weak form of the projection (paper eq. 42) tests equilibrium with one hat function at a
/// time. It is one at its node and zero at all others, so four cells S1 to S4 contribute (a), and
/// its row of the matrix couples nine nodes.
///
/// The couplings of u with u are read from the matrix as it is assembled for a sandwich, at a node
/// in the binder under a sloped surface. A rigid shift costs no energy: they add up to zero. For
/// the paper's element (b) they are of the size of the bulk modulus even where a neighbour could
/// give way by shear alone; mean dilatation (c) lets K act on one number a cell. What the
/// projection adds for B-bar besides, to take out checkerboards of the pressure on patches of four
/// cells, is left out here.

#include <algorithm>
#include <cmath>

#include "base/build_info.hpp"
#include "cases/paper/wavy_grid.hpp"
#include "cases/registry.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/units.hpp"
#include "solver/element/element.hpp"
#include "solver/projection/fixed_pattern.hpp"
#include "solver/projection/support.hpp"

namespace crawford {

namespace {

using namespace units;

constexpr double GPa = 1e9;
constexpr double amplitude = 40.0 * um;

/// A node inside the strip, in the row whose cells are most nearly square.
Node chosen_node(const Grid& grid) {
    int row = 1;
    for (int j = 1; j < grid.rows(); ++j)
        if (std::abs(grid.height(j) - grid.dx()) < std::abs(grid.height(row) - grid.dx())) row = j;
    return {grid.cell_columns() / 2 + grid.cell_columns() / 16, row};
}

/// The sandwich's grid under that surface, and the node looked at.
struct Place {
    Scene scene;
    Grid grid{scene.domain};
    SurfaceField surface = wave(grid, amplitude);
    Node node = chosen_node(grid);

    Vector position(int i, int j) const { return crawford::place(grid, surface, i, j); }
};

Place place_at(Fidelity fidelity) {
    Scene scene = burning_sandwich(fidelity, true);
    scene.domain.half = false;
    return {scene};
}

/// The matrix of the projection per unit of time, from all cells of the grid.
SparseMatrix assembled(const Place& at, Element element) {
    FixedPattern pattern(at.grid, held_unknowns(at.grid, at.scene.bottom.support), {});
    const MaterialMap materials(at.scene.morphology, at.grid);
    size_t block = 0;
    for (int i = 0; i < at.grid.cell_columns(); ++i)
        for (int j = 0; j < at.grid.rows(); ++j)
            pattern.add(block++,
                        stiffness(element, Cell(at.grid, at.surface, i, j),
                                  {materials.bulk_modulus(i, j), materials.shear_modulus(i, j)}));
    return pattern.lower();
}

/// u-u couplings of the node with its neighbours, from the lower left, row by row.
struct Couplings {
    std::vector<double> x, y, value;  ///< [um, um, GPa]
    double sum = 0.0;                 ///< relative to the largest
};

Couplings couplings(const Place& at, Element element) {
    const SparseMatrix lower = assembled(at, element);
    const FixedPattern numbers(at.grid, held_unknowns(at.grid, at.scene.bottom.support), {});
    const int row = numbers.unknown(at.node, 0);
    Couplings result;
    for (int b = -1; b <= 1; ++b)
        for (int a = -1; a <= 1; ++a) {
            const int column = numbers.unknown({at.node.i + a, at.node.j + b}, 0);
            const Vector where = at.position(at.node.i + a, at.node.j + b);
            result.x.push_back(where.x() / um);
            result.y.push_back(where.y() / um);
            result.value.push_back(lower.coeff(std::max(row, column), std::min(row, column)) / GPa);
            result.sum += result.value.back();
        }
    result.sum = std::abs(result.sum) / std::ranges::max(result.value);
    return result;
}

/// psi over its four cells, each sampled where bilinear interpolation of its corners says.
reports::QuadMap hat(const Place& at) {
    constexpr int samples = 24;  // of a cell, each way
    reports::QuadMap map{.columns = 2 * samples,
                         .rows = 2 * samples,
                         .x = {"x", "um", {}},
                         .y = {"y", "um", {}},
                         .fields = {{"psi", "-", {}}}};
    for (int l = 0; l <= 2 * samples; ++l)
        for (int k = 0; k <= 2 * samples; ++k) {
            const int i = k < samples ? -1 : 0, j = l < samples ? -1 : 0;
            const Local here{double(k) / samples - (i + 1), double(l) / samples - (j + 1)};
            const int left = at.node.i + i, low = at.node.j + j;
            const std::array<Vector, 4> corner{at.position(left, low), at.position(left + 1, low),
                                               at.position(left, low + 1),
                                               at.position(left + 1, low + 1)};
            std::array<double, 4> psi{};
            psi[size_t(-i - 2 * j)] = 1.0;  // the corner that is the node
            const Vector where = interpolate(corner, here);
            map.x.values.push_back(where.x() / um);
            map.y.values.push_back(where.y() / um);
            map.fields.front().values.push_back(interpolate(psi, here));
        }
    return map;
}

constexpr reports::PanelSize panel_size{.width = 480, .height = 460};

Outcome fig02(const Request& request) {
    const Place at = place_at(request.fidelity);
    Outcome outcome{reports::Figure("fig02", request.out), {}, {at.scene}};
    outcome.figure.map("hat", hat(at))
        .caption({.grid = grid_text(at.scene), .revision = revision()})
        .set("panel_ratio", double(panel_size.width) / panel_size.height)
        .panel("a", reports::Format::png, panel_size);
    for (const auto& [name, panel, element] :
         {std::tuple{"q1", "b", Element::q1}, std::tuple{"bbar", "c", Element::bbar}}) {
        const Couplings nine = couplings(at, element);
        outcome.figure
            .table(name, {{"x", "um", nine.x}, {"y", "um", nine.y}, {"A_uu", "GPa", nine.value}})
            .panel(panel, reports::Format::svg, panel_size);
        outcome.findings.push_back(
            {std::string(name) + ": u-u coupling of the node with itself", nine.value[4], "GPa"});
        outcome.findings.push_back(
            {std::string(name) + ": sum of its nine couplings, of the largest", nine.sum, "-"});
    }
    return outcome;
}

const Registered here{{.name = "fig02",
                       .figure = "Fig. 2",
                       .shows = "one hat function, its four cells and nine couplings",
                       .physics = {physics::stress},
                       .cost = {.draft = 0.5, .paper = 1.0},
                       .draw = fig02}};

}  // namespace

}  // namespace crawford
