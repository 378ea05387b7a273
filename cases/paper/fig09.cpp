/// # Figure 9: convergence of the burning sandwich in x
///
/// Stress, velocity and reference map of the burning sandwich on 32, 64 and 128 columns against
/// 256, the rows kept, as root mean square (paper eq. 55). The paper reads first order in dx.
///
/// With the finest grid for the truth and three others, any order from 0 to 1 fits as something
/// from 0.8 to 1.4: "first order" is what this way shows of next to anything. Differences between
/// successive grids, drawn beside, say what the order is; stress, singular at the corner, and
/// whatever the notch at the interface touches have less (cases "sandwich-orders" and
/// "sandwich-refinement"). Points are compared at equal x and depth below the surface, so that a
/// difference in how far the surface has burnt is part of that of the reference map.
///
/// In a to c each side of an interface burns as itself; in d to f a node between two materials burns
/// with the mean of their rates, as the paper's marker suggests (`numerics.front`). There the
/// interface lags on every grid, by less on each finer one, and all fields lag with it.

#include <array>
#include <string>
#include <vector>

#include "base/build_info.hpp"
#include "cases/paper/read_twice.hpp"
#include "cases/paper/refined_sandwich.hpp"
#include "cases/registry.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;

std::vector<Compared> quantities() {
    return {{"sigma_11", "MPa", MPa, false}, {"sigma_22", "MPa", MPa, false},
            {"sigma_33", "MPa", MPa, false}, {"tau", "MPa", MPa, false},
            {"u", "um/s", um / s, true},     {"v", "um/s", um / s, true},
            {"xi_1", "um", um, true},        {"xi_2", "um", um, true}};
}

Refinement::Fields fields(const Snapshot& last) {
    const auto& stress = last.stress;
    const auto& node = last.position;
    Refinement::Fields fields(4, Lattice<double>(stress.columns(), stress.rows()));
    fields.resize(8, Lattice<double>(node.columns(), node.rows()));
    for (int i = 0; i < stress.columns(); ++i)
        for (int j = 0; j < stress.rows(); ++j) {
            const PlaneStress& here = stress(i, j);
            const std::array components{here.s11, here.s22, here.s33, here.s12};
            for (size_t k = 0; k < components.size(); ++k) fields[k](i, j) = components[k];
        }
    for (int i = 0; i < node.columns(); ++i)
        for (int j = 0; j < node.rows(); ++j)
            for (int k = 0; k < 2; ++k) {
                fields[size_t(4 + k)](i, j) = last.velocity(i, j)[k];
                fields[size_t(6 + k)](i, j) = last.reference_map(i, j)[k];
            }
    return fields;
}

struct OfFront {
    Front front;
    OrderSet set;
};
const std::vector<OfFront> fronts{
    {Front::faster_side, {"sandwich", ""}},
    {Front::mean_of_materials, {"mean", "the mean of the rates where materials meet"}}};

Outcome fig09(const Request& request) {
    Outcome outcome{reports::Figure("fig09", request.out), {}, {}};
    std::string grids, step;
    for (const auto& [front, set] : fronts) {
        const auto burns = refined_sandwich(request, front);
        Refinement refinement(quantities(), burns.front()->scene.domain.width);
        for (const auto& burn : burns) {
            refinement.add_grid(burn->scene.domain.nx, fields(burn->last));
            outcome.scenes.push_back(burn->scene);
        }
        refinement.report(outcome, set.name);
        grids = grids_text(burns);
        step = step_text(burns.back()->scene);
    }
    outcome.figure.caption(
        {.grid = grids, .step = step, .revision = revision(), .note = "the paper prints order 1"});
    for (const char* panel : {"a", "b", "c", "d", "e", "f"}) outcome.figure.panel(panel);
    return outcome;
}

std::vector<Scene> burns(Fidelity fidelity) {
    std::vector<Scene> all;
    for (const OfFront& of : fronts)
        for (Scene& scene : refined_scenes(fidelity, of.front)) all.push_back(std::move(scene));
    return all;
}

ledger::Rows claims(const ledger::Evidence& evidence) {
    // "A first-order convergence": what is nearer to 1 than to 0.5 or 1.5.
    const auto first_order = [&](const std::string& claim, const std::string& where,
                                 const std::vector<std::string>& quantities) {
        return judged_order(evidence, {claim, where, "fig09", "-", "first order", 1.0, 0.25},
                            quantities, fronts[0].set, fronts[1].set);
    };
    return {first_order("order of stress in dx, burning sandwich", "Fig. 9a", stress_names),
            first_order("order of velocity in dx, burning sandwich", "Fig. 9b", {"u", "v"}),
            first_order("order of the reference map in dx, burning sandwich", "Fig. 9c",
                        {"xi_1", "xi_2"})};
}

const Registered here{
    {.name = "fig09",
     .figure = "Fig. 9",
     .shows = "burning sandwich: errors against the width of a column",
     .physics = {physics::stress, physics::reference_map, physics::grid, physics::sandwich},
     .cost = {.draft = 12.0, .paper = 740.0},
     .draw = fig09,
     .burns = burns,
     .claims = claims}};

}  // namespace

}  // namespace crawford
