/// # Laminate: does the projection see an interface exactly where the grid has one, and how far off
/// is it where the grid has none?
///
/// Layers along y, periodic in x, pressed at their ends from rest in one quasi-static step. The
/// exact field (reference/elastic_laminate.hpp) is linear within each layer, so bilinear elements
/// hold it without error if a grid line lies on every interface: what is left is round-off, however
/// coarse or clustered the grid. That is gated as a bound, since an error at round-off has no
/// order.
///
/// An even pressure bends the end of most laminates, because their layers want to carry different
/// sigma_yy. Two ways avoid that. The materials of the first study are matched
/// (reference::balanced_strip): the strip is 19 times softer in shear and 19 times stiffer in bulk.
/// The second takes AP and binder (contrast 5000, K/mu = 4268) and a stress from the start that is
/// even in each layer and lacks what the layer is about to take: s_yy = -p_c - sigma_yy. It exerts
/// no force inside a layer and none across an interface.
///
/// In the third the interface cuts a column of cells, always at the same third. Such a column holds
/// the harmonic means of K and mu. They are not the column's true stiffness: across the layers the
/// true one is the harmonic mean of lambda + 2 mu, which is larger, along them it is closer to the
/// arithmetic mean. The solver therefore solves, exactly but for the ends, the laminate with a thin
/// third layer of width h and another material. Its strain is wrong by a fixed amount on a share h
/// of the period, so displacements are of order 1; stress is wrong by a fixed amount on that share
/// and by h elsewhere: order 1 in L1 and 1/2 in L2. An order does not tell one mean from another,
/// so the change of axial strain is held against that of the laminate of three layers, in a window
/// so deep (six widths) that its lowest cells feel nothing of the end.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/verify/projection/pressed_laminate.hpp"

namespace crawford {

namespace {

using namespace units;
using namespace pressed_laminate;
using reference::LaminateConditions;
using reports::at_most;
using reports::between;
using reports::expect;
using reports::Norm;

constexpr auto softening = "change of axial strain / that of three layers";

double relative_error(const std::vector<double>& values, const std::vector<double>& truth) {
    return reports::distance(Norm::Linf, values, truth) / reports::norm(Norm::Linf, truth);
}

reports::Measurement aligned(const LaminateConditions& laminate, int nx) {
    reports::Measurement result(1.0 / nx);
    for (const auto& [element, name] :
         {std::pair{Element::bbar, "B-bar"}, std::pair{Element::q1, "q1"}}) {
        Scene pressed = scene(laminate, nx, 2.0);
        pressed.numerics.element = element;
        const Run run(laminate, pressed);
        const std::string tail = std::string(", ") + name;
        result.value("u" + tail, relative_error(run.u, run.u_exact))
            .value("v" + tail, relative_error(run.v, run.v_exact))
            .value("sigma_xx" + tail, relative_error(run.xx, run.xx_exact))
            .value("sigma_yy" + tail, relative_error(run.yy, run.yy_exact));
    }
    return result;
}

/// Axial strain of the laminate of three layers: the third is a column of cells on either side of
/// the strip, of which the strip fills a part, and has the harmonic means of K and mu.
double strain_of_three(const LaminateConditions& laminate, int nx) {
    const double columns = 0.5 * laminate.strip / width * nx;  // of half the strip
    const double part = columns - std::floor(columns);
    const auto harmonic = [&](double inner, double outer) {
        return 1.0 / (part / inner + (1.0 - part) / outer);
    };
    reference::Material third = laminate.outer;
    third.bulk_modulus = harmonic(laminate.inner.bulk_modulus, laminate.outer.bulk_modulus);
    third.shear_modulus = harmonic(laminate.inner.shear_modulus, laminate.outer.shear_modulus);
    const double inner = 2.0 * std::floor(columns) / nx;
    const double cut = 2.0 / nx;
    return -pressure /
           reference::axial_stiffness(
               {{laminate.inner, inner}, {third, cut}, {laminate.outer, 1.0 - inner - cut}});
}

constexpr double cut_strip = 130.0 * um;  // ends at a third of a cell where nx = 16, 64, 256

reports::Measurement cut(int nx) {
    const LaminateConditions laminate = matched(cut_strip);
    const Run run(laminate, scene(laminate, nx, 0.0));
    reports::Measurement result(1.0 / nx);
    result.field("u", run.u, run.u_exact)
        .field("v", run.v, run.v_exact)
        .field("sigma_xx", run.xx, run.xx_exact)
        .field("sigma_yy", run.yy, run.yy_exact);
    return result;
}

reports::Measurement cut_and_deep(int nx) {
    const LaminateConditions laminate = matched(cut_strip);
    Scene pressed = scene(laminate, nx, 0.0);
    pressed.domain.depth = 6.0 * width;
    const double change = Run(laminate, pressed).axial_strain - laminate.axial_strain;
    reports::Measurement result(1.0 / nx);
    result.value(softening, change / (strain_of_three(laminate, nx) - laminate.axial_strain));
    return result;
}

reports::Study exact_on_grid_lines(const std::string& name, const LaminateConditions& laminate,
                                   double tolerance) {
    reports::Study study("projection-laminate, " + name);
    study.refines("columns", {8, 32})
        .measure([laminate](int nx) { return aligned(laminate, nx); })
        .covers({term::elasticity, term::equilibrium, term::traction, term::support,
                 term::elastic_interface, term::incompressibility, term::clustering});
    for (const char* element : {", B-bar", ", q1"})
        for (const char* quantity : {"u", "v", "sigma_xx", "sigma_yy"})
            for (const int grid : {8, 32})
                study.bound(std::string(quantity) + element, grid, at_most(tolerance),
                            "linear within each layer: round-off, which contrast and K/mu amplify");
    return study;
}

std::vector<reports::Study> studies() {
    reports::Study between_lines("projection-laminate, interface inside cells");
    between_lines.refines("columns", {16, 64, 256})
        .measure(cut)
        .covers({term::elastic_interface, term::equilibrium})
        .gate("u", Norm::L2, expect(1.0).within(0.1), "wrong strain in a column of width h")
        .gate("v", Norm::L2, expect(1.0).within(0.02), "wrong stiffness of a share h of the width")
        .gate("sigma_xx", Norm::L1, expect(1.0).within(0.1), "one number, wrong by h; and the ends")
        .gate("sigma_yy", Norm::L1, expect(1.0).within(0.1), "wrong by a fixed amount on a share h")
        .gate("sigma_yy", Norm::L2, expect(0.5).within(0.05, 0.2),
              "the root of that share; what is wrong by h elsewhere still shows on coarse grids");
    reports::Study moduli("projection-laminate, moduli of cut cells");
    moduli.refines("columns", {16, 64})
        .measure(cut_and_deep)
        .covers({term::elastic_interface})
        .bound(softening, 16, between(0.999, 1.001),
               "three layers, but for what the end sends down")
        .bound(softening, 64, between(0.999, 1.001),
               "three layers, but for what the end sends down");
    return {exact_on_grid_lines("matched layers", matched(120.0 * um), 2e-11),
            exact_on_grid_lines("AP and binder", laminate(reference::binder(), 60.0 * um, -1e-3),
                                2e-10),
            between_lines, moduli};
}

const Registered here{{.name = "projection-laminate",
                       .figure = "-",
                       .shows = "pressed laminate against its exact solution",
                       .cost = {.verify = 2.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
