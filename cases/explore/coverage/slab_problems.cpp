/// Steady burning slabs: the problems of cases/verify/slab.
#include <fmt/format.h>

#include "cases/explore/coverage/known_problem.hpp"
#include "cases/scenes/slab.hpp"
#include "cases/units.hpp"
#include "reference/slab.hpp"

namespace crawford {

namespace {

using namespace units;

Slab slab_of(const std::string& material, double flux, int cells) {
    return slab(material, {.cells = cells, .clustering = 2.0, .depth = 1200.0 * um})
        .heated(flux)
        .pressed(2.0 * MPa);
}

/// What cells have, at the node between two of them.
double at_node(const SlabProfile& run, const std::vector<double>& cells, size_t j) {
    const double below = run.cell_weight[j - 1], above = run.cell_weight[j];
    return (above * cells[j - 1] + below * cells[j]) / (above + below);
}

std::vector<KnownValue> steady_values(const Slab& slab, int rows) {
    const SlabProfile run = burn_to_steady(slab.scene());
    const reference::Slab exact(slab.conditions(reference::SlabModel::eulerian));
    std::vector<KnownValue> values{
        {"v at 1 [m/s]", run.velocity.back(), exact.state(0.0).velocity},
        {"T at 1 [K]", run.temperature.back(), exact.surface_temperature()},
        {"burn rate [m/s]", run.burn_rate, exact.burn_rate()}};
    for (const double up : {0.625, 0.75, 0.875}) {
        const auto j = size_t(up * rows);
        const reference::SlabState truth = exact.state(run.node_y[j]);
        const auto add = [&](const char* what, const char* unit, double value, double expected) {
            values.push_back({fmt::format("{} at {:g} [{}]", what, up, unit), value, expected});
        };
        add("T", "K", run.temperature[j], truth.temperature);
        add("v", "m/s", run.velocity[j], truth.velocity);
        add("sigma_11", "Pa", at_node(run, run.stress_11, j), truth.stress_11);
        add("F_22", "-", at_node(run, run.deformation_gradient_22, j),
            truth.deformation_gradient_22);
    }
    return values;
}

}  // namespace

std::vector<KnownProblem> slab_problems(Fidelity fidelity) {
    std::vector<KnownProblem> problems;
    const auto add = [&](const std::string& name, const auto& slab) {
        problems.push_back({"slab", "slab, " + name, 2.0, grids_of(fidelity, 8),
                            [=](int rows) { return steady_values(slab(rows), rows); }});
    };
    constexpr double flux = cal / (s * cm2);
    add("AP", [](int n) { return slab_of("AP", 200.0 * flux, n).regressing(0.45 * cm / s); });
    add("binder",
        [](int n) { return slab_of("binder", 100.0 * flux, n).regressing(0.45 * cm / s); });
    add("AP by its law", [](int n) { return slab_of("AP", 200.0 * flux, n).burning_by_law(); });
    add("binder by its law",
        [](int n) { return slab_of("binder", 160.0 * flux, n).burning_by_law(); });
    return problems;
}

}  // namespace crawford
