/// # Figure 3: does the solver find the thermal layer of burning AP?
///
/// A strip of ammonium perchlorate regresses at 0.45 cm/s under 200 cal/(s cm2) and 2 MPa. In one
/// dimension the steady state has an exact solution (reference/slab.hpp), so this is the one figure
/// of the paper with a truth to stand on; the study `slab` reads the order of the error from it.
///
/// The solver convects with r_b + v at constant density; Kuznetsov and Stewart, whose solution the
/// paper draws, take strain as small and drop v. Both are drawn: the 4 K between them at the
/// surface are model and not error, and no grid makes them smaller. Their F is measured from
/// stress-free material, the solver's from what enters the window already under pressure: 6e-5
/// apart.

#include <fmt/format.h>

#include "cases/catalogue/columns.hpp"
#include "cases/catalogue/registry.hpp"
#include "cases/catalogue/slab.hpp"
#include "cases/catalogue/units.hpp"
#include "reference/slab.hpp"
#include "solver/output/build_info.hpp"

namespace crawford {

namespace {

using namespace units;
using reference::SlabModel;
using reports::Column;

int cells(Fidelity fidelity) {
    return fidelity == Fidelity::draft ? 48 : fidelity == Fidelity::paper ? 96 : 192;
}

std::vector<Column> line(const reference::Slab& slab) {
    std::vector<Column> columns{
        {"depth", "um", {}}, {"T", "K", {}}, {"p", "MPa", {}}, {"v", "um/s", {}}, {"F22", "-", {}}};
    for (int k = 0; k <= 240; ++k) {
        const double y = -k * 1.0 * um;
        const reference::SlabState state = slab.state(y);
        const double row[] = {-y / um, state.temperature, state.pressure / MPa,
                              state.velocity / (um / s), state.deformation_gradient_22};
        for (std::size_t c = 0; c < columns.size(); ++c) columns[c].values.push_back(row[c]);
    }
    return columns;
}

Outcome fig03(const Request& request) {
    const Slab ap = slab("AP", {.cells = cells(request.fidelity), .clustering = 2.0})
                        .regressing(0.45 * cm / s)
                        .heated(200.0 * cal / (s * cm2))
                        .pressed(2.0 * MPa);
    const Scene scene = ap.scene();
    const SlabProfile run = burn_to_steady(scene);
    const reference::Slab exact(ap.conditions(SlabModel::eulerian));
    const reference::Slab small_strain(ap.conditions(SlabModel::kuznetsov_stewart));

    reports::Figure figure("fig03", request.out, "cases/fig03.gp");
    figure
        .table("nodes", {{"depth", "um", scaled(run.node_y, -um)},
                         {"T", "K", run.temperature},
                         {"v", "um/s", scaled(run.velocity, um / s)}})
        .table("cells", {{"depth", "um", scaled(run.cell_y, -um)},
                         {"p", "MPa", scaled(run.pressure, MPa)},
                         {"F22", "-", run.deformation_gradient_22}})
        .table("exact", line(exact))
        .table("small_strain", line(small_strain))
        .caption({.grid = fmt::format("1 x {}, clustering 2", scene.domain.ny),
                  .step = "steady",
                  .revision = revision()});
    for (const char* panel : {"a", "b", "c", "d"}) figure.panel(panel);
    const double surface = run.temperature.back();
    return {figure,
            {{"surface temperature", surface, "K"},
             {"error: distance to the exact solution", surface - exact.surface_temperature(), "K"},
             {"model: distance to Kuznetsov-Stewart", surface - small_strain.surface_temperature(),
              "K"}},
            {scene}};
}

const Registered here{{.name = "fig03",
                       .figure = "Fig. 3",
                       .shows = "thermal layer of AP against the exact slab",
                       .physics = {physics::heat, physics::stress, physics::coupling,
                                   physics::reference_map, physics::slab},
                       .cost = {.draft = 1.0, .paper = 3.0},
                       .draw = fig03}};

}  // namespace

}  // namespace crawford
