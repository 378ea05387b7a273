/// # Coupled: is the whole step right, and of which order?
///
/// Every term of the model at once, through the very loop that burns a propellant: a manufactured
/// solid (reference/manufactured_burning.hpp) whose sloped surface regresses and travels by its own
/// pyrolysis law, whose heat conducts, convects and works, whose stress is carried, turned, heated
/// and strained, on the clustered grid that moves with the surface. What the equations lack to have
/// it for a solution enters as heat, stress, force, flux and traction; burn rate and reference map
/// need nothing added. A term that is wrong by its sign, factor, place or time shows as an error
/// that does not converge.
///
/// In space, the step falls with the cell and the second-order step is taken, so that all must
/// converge at order 2. In time, a fixed grid is stepped with ever shorter steps, and successive
/// differences show the order of the step alone: 1 for the paper's, 2 for the step that looks back.
/// (They start from what a few very short steps make of the exact state. The exact state solves no
/// grid's equations; the spike of velocity that cures this is of size h^2/dt, and would end the
/// orders at some 60 steps.)

#include <array>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/verify/coupled/manufactured_burn.hpp"

namespace crawford {

namespace {

using reports::expect;
using reports::Norm;

constexpr double end = 1e-3;  // [s], in which the surface burns 4.5 um and the solid turns by 0.1

struct Gated {
    const char* quantity;
    const char* reason;
};

/// Quantities and why they converge at order 2 in space.
constexpr std::array gated{
    Gated{"T", "bilinear elements and centred convection"},
    Gated{"v", "B-bar on a smooth solution, exact quadrature of the stress it carries"},
    Gated{"phi", "third-order slopes, burn rate of a second-order temperature"},
    Gated{"xi", "second-order ENO; where its stencil changes the error is of the same order"},
    Gated{"sigma_11", "strain at the centre of a bilinear cell; WENO3 is of order 2 at extrema"},
    Gated{"sigma_22", "as sigma_11"},
    Gated{"sigma_33", "as sigma_11"},
    Gated{"sigma_12", "as sigma_11"},
    Gated{"F", "centred differences of xi at the centre"}};

const std::vector<std::string> terms{
    term::heat_storage,     term::heat_convection, term::heat_conduction, term::stress_work,
    term::gas_flux,         term::reaction_flux,   term::elasticity,      term::stress_advection,
    term::jaumann_rotation, term::thermal_stress,  term::equilibrium,     term::traction,
    term::support,          term::pyrolysis,       term::surface_motion,  term::map_advection,
    term::deformation,      term::clustering,      term::slope,           term::grid_motion,
    term::time_step};

reports::Study in_space() {
    reports::Study study("coupled, in space");
    study.refines("cells", {16, 32, 64, 128}).covers(terms).measure([](int cells) {
        return run_manufactured(
            {.cells = cells, .steps = cells / 8, .end = end / 2, .scheme = Stepping::bdf2},
            1.0 / cells);
    });
    for (const Gated& g : gated)
        study.gate(g.quantity, Norm::L2, expect(2.0).within(0.15).from(32), g.reason);
    study.gate("T", Norm::Linf, expect(2.0).within(0.15).from(32), "the same at the worst node");
    return study;
}

/// The same on columns that are clustered as those of a sandwich: every difference along a row and
/// every cell's width knows it.
reports::Study on_clustered_columns() {
    reports::Study study("coupled, in space, clustered columns");
    study.refines("cells", {24, 48, 96}).covers(terms).measure([](int cells) {
        return run_manufactured({.cells = cells,
                                 .clustering_x = 1.0,
                                 .steps = cells / 8,
                                 .end = end / 2,
                                 .scheme = Stepping::bdf2},
                                1.0 / cells);
    });
    for (const Gated& g : gated)
        study.gate(g.quantity, Norm::L2,
                   g.quantity == std::string("v") ? expect(2.0).or_better(0.25).scattering(0.5)
                                                  : expect(2.0).within(0.25),
                   g.reason);  // v falls by 3.1, then 2.3: what makes its coarse error is gone
    return study;
}

/// Successive differences between runs of more and more steps: the grid's error is in all alike,
/// and they start from one state that the grid has settled.
reports::Study in_time(const std::string& name, const ManufacturedBurn& burn, double order,
                       const std::string& reason) {
    reports::Study study("coupled, in time, " + name);
    study.refines("steps", {16, 32, 64, 128}).covers({term::time_step}).measure([burn](int steps) {
        ManufacturedBurn run = burn;
        run.steps = steps;
        return run_manufactured(run, 1.0 / steps);
    });
    for (const Gated& g : gated)
        study.difference_gate(g.quantity, Norm::L2, expect(order).within(0.15), reason);
    return study;
}

std::vector<reports::Study> studies() {
    constexpr int cells = 16;
    const ManufacturedBurn paper{.cells = cells,
                                 .end = end,
                                 .scheme = Stepping::euler,
                                 .start = Start::settled,
                                 .coupling = Coupling::lagged};
    const ManufacturedBurn two_step{
        .cells = cells, .end = end, .scheme = Stepping::bdf2, .start = Start::settled};
    return {
        in_space(), on_clustered_columns(),
        in_time("paper's step", paper, 1.0,
                "forward Euler; heat is second order alone, but its motion lags by a step"),
        in_time("two-step", two_step, 2.0,
                "BDF2, all explicit terms extrapolated; its first step is Euler's, once. Xi, and F "
                "with it, less where ENO2 switches its stencil")};
}

const Registered here{{.name = "coupled",
                       .figure = "-",
                       .shows = "the whole step against a manufactured burning solid",
                       .cost = {.verify = 60.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
