/// The whole step at single places: the problem of cases/verify/coupled/coupled.cpp.
#include "cases/explore/coverage/known_problem.hpp"
#include "cases/verify/coupled/manufactured_burn.hpp"

namespace crawford {

std::vector<KnownProblem> coupled_problems(Fidelity fidelity) {
    // Of the second-order step: dt falls with h.
    const auto of = [&](const std::string& name, double clustering_x) -> KnownProblem {
        return {"coupled", "coupled, " + name, 2.0, grids_of(fidelity, 8), [=](int cells) {
                    return values_of_manufactured({.cells = cells,
                                                   .clustering_x = clustering_x,
                                                   .steps = cells / 8,
                                                   .end = 0.5e-3,
                                                   .scheme = Stepping::bdf2},
                                                  {{0.25, 0.5}, {0.5, 0.75}});
                }};
    };
    return {of("even columns", 0.0), of("clustered columns", 1.0)};
}

}  // namespace crawford
