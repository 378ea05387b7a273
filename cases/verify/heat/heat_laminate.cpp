/// # Heat, laminate: does heat pass rightly from one conductor into another?
///
/// A strip between blocks that conduct and store heat differently, in the sandwich's geometry. The
/// temperature (reference/thermal_laminate.hpp) has a kink at each interface where the conducted
/// heat has none, and swings in time. What enters through the surface jumps at the interface, and
/// is given to the burning law, which shares it out by volume fraction. dt falls with h.
///
/// With grid lines on the interfaces every cell is of one material and the elements are of second
/// order, however large the jump: here also 1000 in conductivity, in capacity, or in both.
///
/// An interface inside a cell is another matter. Conductors one behind the other in the direction
/// of the heat are in series: half and half they conduct as the harmonic mean. A cut cell that is
/// asked for the arithmetic mean k = (k1 + k2)/2, as here, conducts rightly along the interface and
/// too much across it, and the drop in temperature over the cell is short of f h (k1 - k2)^2/(4 k
/// k1 k2), f the heat that crosses: first order in h. (The strip is made wider by one cell of each
/// grid, so that its edges lie in the middle of a cell on all of them.) What other means do is
/// told by cut-cells.

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/verify/heat/heated_laminate.hpp"
#include "solver/mesh/grid.hpp"

namespace crawford {

namespace {

using reference::TwoConductors;
using reports::between;
using reports::expect;
using reports::Norm;

constexpr auto drop = "missing drop over the cut cell, of the derived";

reports::Study study(const std::string& what, const TwoConductors& solid) {
    reports::Study study("heat-laminate, " + what);
    study.refines("cells", {32, 64, 128, 256})
        .measure([=](int cells) {
            return error_of_temperature(advance(heated_laminate(solid, cells), cells / 8),
                                        1.0 / cells);
        })
        .covers({term::heat_interface, term::heat_conduction, term::heat_storage, term::gas_flux})
        .gate("T", Norm::L2, expect(2.0).within(0.1), "grid lines on the interfaces")
        .gate("T", Norm::Linf, expect(2.0).within(0.1), "the kink lies on a grid line");
    return study;
}

/// Half way down, where neither surface nor bottom is near.
double middle(const Grid& grid) {
    return grid.eta(grid.rows() / 2);
}

/// f h (k1 - k2)^2/(4 k k1 k2), at the end [K].
double derived_drop(const TwoConductors& solid, const PrescribedHeat& heat) {
    const Grid grid(heat.scene.domain);
    const double inner = solid.inner_conductivity;
    const double outer = solid.outer_conductivity;
    const double crossing =
        reference::ThermalLaminate(solid).crossing_heat(middle(grid), heat.scene.time.end);
    return crossing * grid.dx() * (inner - outer) * (inner - outer) /
           (2.0 * (inner + outer) * inner * outer);
}

/// By how much the temperature rises too little over the cell that the right interface cuts [K].
double found_drop(const PrescribedHeat& heat, const FoundHeat& found) {
    const Grid grid(heat.scene.domain);
    const int left = 5 * grid.cell_columns() / 8;
    const auto error = [&](int i) {
        const auto k = size_t(i * (grid.rows() + 1) + grid.rows() / 2);
        return found.temperature[k] - found.exact[k];
    };
    return error(left) - error(left + 1);
}

reports::Study cut(const TwoConductors& solid) {
    reports::Study study("heat-laminate, interface inside a cell");
    study.refines("cells", {32, 64, 128, 256})
        .measure([=](int cells) {
            const TwoConductors wider = widened(solid, cells);
            PrescribedHeat heat = heated_laminate(wider, cells);
            heat.scene.numerics.cut_cell_conductivity = CutConductivity::arithmetic;
            const FoundHeat found = advance(heat, cells / 8);
            return error_of_temperature(found, 1.0 / cells)
                .value(drop, found_drop(heat, found) / derived_drop(wider, heat));
        })
        .covers({term::heat_interface})
        .gate("T", Norm::L2, expect(1.0).within(0.1).from(64),
              "arithmetic conductivity across a cut cell, once heat has gone some cells far")
        .gate("T", Norm::Linf, expect(1.0).within(0.1).from(64), "a share of the missing drop")
        .bound(drop, 256, between(0.95, 1.05),
               "all of it: next comes h over half the strip, 1/32 here");
    return study;
}

std::vector<reports::Study> studies() {
    return {study("AP and binder", propellant_in_heat()),
            study("conductivity 1e-3", conductors(1e-3, 1.0)),
            study("capacity 1e3", conductors(1.0, 1e3)),
            study("conductivity and capacity 1e-3", conductors(1e-3, 1e-3)),
            cut(conductors(0.2, 1.0))};
}

const Registered here{{.name = "heat-laminate",
                       .figure = "-",
                       .shows = "heat that crosses an interface, on a grid line and inside a cell",
                       .cost = {.verify = 10.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
