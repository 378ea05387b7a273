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
///
/// A ligament of two cells between others has one difference and nothing beyond. A stress that
/// grows evenly along the rows is carried through its second cell at exactly that slope; into its
/// first one flows what is there.

#include <algorithm>
#include <cmath>
#include <utility>

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

/// A solid that moves along the rows while its surface falls, and the stress step that carries it.
class Body {
public:
    explicit Body(Scene scene)
        : scene_(std::move(scene)),
          grid_(scene_.domain),
          materials_(scene_.morphology, grid_),
          checkerboard_(grid_, materials_, scene_.numerics.element),
          step_(scene_, grid_, materials_, checkerboard_) {}

    /// Each material's own stress, in all its cells.
    StressField held() const {
        StressField stress(grid_.cell_columns(), grid_.rows(),
                           int(stress_points(scene_.numerics.element).size()));
        for (int i = 0; i < grid_.cell_columns(); ++i)
            for (int j = 0; j < grid_.rows(); ++j) {
                const bool is_ap = materials_.fraction()(i, j) == 1.0;
                for (auto& point : stress.deviator) point(i, j) = is_ap ? in_ap : in_binder;
                stress.pressure(i, j) = is_ap ? pressure_in_ap : pressure_in_binder;
            }
        return stress;
    }

    /// One step to the right (1) or left (-1), at 1 cm/s. Returns by how much the solid moved [m].
    double carry(StressField& stress, double direction) const {
        const SurfaceField surface(size_t(grid_.node_columns()), 0.0);
        const SurfaceField surface_rate(size_t(grid_.node_columns()), -0.45 * cm / s);
        const NodeVectors velocity(grid_.node_columns(), grid_.rows() + 1,
                                   Vector(direction * cm / s, 0.0));
        const double dt = grid_.height(grid_.rows() - 1) / (3.0 * cm / s);
        step_.predict(stress, {surface, surface_rate, velocity}, {}, 0.0, dt);
        return direction * cm / s * dt;
    }

private:
    Scene scene_;
    Grid grid_;
    MaterialMap materials_;
    Checkerboard checkerboard_;
    StressStep step_;
};

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
    const Body body(sandwich(cells, element));
    const StressField before = body.held();
    StressField stress = before;
    body.carry(stress, direction);
    return largest_change(before, stress);
}

/// Relative error of the rate of s11, -u ds11/dx, in the second of two cells that hold a stress of
/// even slope, after the solid moved a third of a cell.
double ligament(int cells, double direction) {
    const double column = width / cells;
    Scene scene = sandwich(cells, Element::bbar);
    scene.morphology.shape = Sandwich{2.0 * column};
    const Body body(scene);
    const int left = cells / 2 - 1;
    StressField stress = body.held();
    constexpr double rise = 10.0 * MPa;  // from the first cell to the second
    for (auto& point : stress.deviator)
        for (int j = 0; j < cells; ++j) point(left + 1, j).s11 += rise;
    const StressField before = stress;
    const double moved = body.carry(stress, direction) / column;
    const int second = direction > 0.0 ? left + 1 : left;
    const double change =
        stress.deviator[0](second, cells / 2).s11 - before.deviator[0](second, cells / 2).s11;
    return -change / (moved * rise) - 1.0;
}

reports::Study through_a_ligament() {
    reports::Study study("advection-interface, ligament of two cells");
    study.refines("cells", {32, 64})
        .covers({term::stress_advection, term::elastic_interface})
        .measure([](int cells) {
            return reports::Measurement(1.0 / cells)
                .value("rate of s11, to the right / exact - 1", ligament(cells, 1.0))
                .value("rate of s11, to the left / exact - 1", ligament(cells, -1.0));
        });
    for (const char* quantity :
         {"rate of s11, to the right / exact - 1", "rate of s11, to the left / exact - 1"})
        study.bound(quantity, 64, reports::between(-1e-9, 1e-9),
                    "one difference is exact for an even slope: round-off");
    return study;
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
    return {study, through_a_ligament()};
}

const Registered here{{.name = "advection-interface",
                       .figure = "-",
                       .shows = "stress carried beside an interface stays in its material",
                       .cost = {.verify = 0.5},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
