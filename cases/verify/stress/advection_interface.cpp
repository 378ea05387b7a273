/// # Stress at an interface: does it stay in its own material?
///
/// Beside an interface AP may hold 100 MPa in shear where binder holds next to none. A stencil of
/// advection that reads across the interface mixes the two, and what AP's stress leaves in binder
/// can relax only through a huge strain. No material crosses its own interface, so neither does its
/// stress: each material here holds a constant stress of its own, and however fast and whichever
/// way the solid moves along the rows, and up through the surface, nothing may change.
///
/// The truth is exact, the stencils repeat values of one material, and differences of equal numbers
/// are zero: so is the bound, but for round-off.

#include <algorithm>
#include <cmath>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "solver/stress/stress_step.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::at_most;

constexpr double width = 240.0 * um;
constexpr Deviator in_ap{100.0 * MPa, -60.0 * MPa, 40.0 * MPa};
constexpr Deviator in_binder{0.1 * MPa, -0.05 * MPa, 0.02 * MPa};
constexpr double pressure_in_ap = 80.0 * MPa;
constexpr double pressure_in_binder = 2.0 * MPa;

Scene sandwich(int cells, Element element) {
    Scene scene;
    scene.domain = {.width = width, .depth = width, .nx = cells, .ny = cells};
    scene.morphology = {.shape = Sandwich{0.25 * width},
                        .materials = {ammonium_perchlorate(), htpb_binder()}};
    scene.numerics.element = element;
    return scene;
}

/// Each material's own stress, in all its cells.
StressField held(const MaterialMap& materials, const Grid& grid, Element element) {
    StressField stress(grid.cell_columns(), grid.rows(), int(stress_points(element).size()));
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j) {
            const bool is_ap = materials.fraction()(i, j) == 1.0;
            for (auto& point : stress.deviator) point(i, j) = is_ap ? in_ap : in_binder;
            stress.pressure(i, j) = is_ap ? pressure_in_ap : pressure_in_binder;
        }
    return stress;
}

double largest_change(const StressField& before, const StressField& after) {
    double largest = 0.0;
    for (size_t c = 0; c < before.pressure.values().size(); ++c) {
        for (size_t k = 0; k < before.deviator.size(); ++k) {
            const Deviator d = after.deviator[k].values()[c] - before.deviator[k].values()[c];
            largest = std::max({largest, std::abs(d.s11), std::abs(d.s22), std::abs(d.s12)});
        }
        largest =
            std::max(largest, std::abs(after.pressure.values()[c] - before.pressure.values()[c]));
    }
    return largest;
}

/// [Pa] after one step in which the solid moves by a third of a cell along the rows.
double leak(int cells, Element element, double direction) {
    const Scene scene = sandwich(cells, element);
    const Grid grid(scene.domain);
    const MaterialMap materials(scene.morphology, grid);
    const Checkerboard checkerboard(grid, materials, element);
    const StressStep step(scene, grid, materials, checkerboard);
    const SurfaceField surface(size_t(grid.node_columns()), 0.0);
    const SurfaceField surface_rate(size_t(grid.node_columns()), -0.45 * cm / s);
    const NodeVectors velocity(grid.node_columns(), grid.rows() + 1,
                               Vector(direction * cm / s, 0.0));
    const CellField no_heat;
    const StressField before = held(materials, grid, element);
    StressField stress = before;
    const double dt = grid.height(grid.rows() - 1) / (3.0 * cm / s);
    step.predict(stress, {surface, surface_rate, velocity}, no_heat, 0.0, dt);
    return largest_change(before, stress);
}

std::vector<reports::Study> studies() {
    reports::Study study("advection-interface");
    study.refines("cells", {32, 64})
        .covers({term::stress_advection, term::elastic_interface, term::moving_morphology})
        .measure([](int cells) {
            return reports::Measurement(1.0 / cells)
                .value("leak, B-bar, to the right [Pa]", leak(cells, Element::bbar, 1.0))
                .value("leak, B-bar, to the left [Pa]", leak(cells, Element::bbar, -1.0))
                .value("leak, q1, to the right [Pa]", leak(cells, Element::q1, 1.0));
        });
    for (const char* quantity : {"leak, B-bar, to the right [Pa]", "leak, B-bar, to the left [Pa]",
                                 "leak, q1, to the right [Pa]"})
        study.bound(quantity, 64, at_most(1e-6),
                    "round-off of 100 MPa; 7 MPa where a stencil reads across");
    return {study};
}

const Registered here{{.name = "advection-interface",
                       .figure = "-",
                       .shows = "stress carried beside an interface stays in its material",
                       .cost = {.verify = 0.5},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
