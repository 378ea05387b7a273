#include <algorithm>
#include <iterator>

#include "cases/explore/coverage/known_problem.hpp"

namespace crawford {

std::vector<int> grids_of(Fidelity fidelity, int step) {
    std::vector<int> grids;
    for (const int grid : {8, 12, 16, 24, 32, 48, 64, 96, 128})
        if (grid % step == 0 && (grid <= 64 || fidelity != Fidelity::draft)) grids.push_back(grid);
    return grids;
}

std::vector<KnownProblem> known_problems(Fidelity fidelity) {
    std::vector<KnownProblem> all;
    for (const auto& some : {heat_problems, slab_problems, front_problems, elastic_problems,
                             coupled_problems, study_problems})
        std::ranges::move(some(fidelity), std::back_inserter(all));
    std::ranges::stable_sort(all, [](const KnownProblem& a, const KnownProblem& b) {
        return std::tie(a.kind, a.name) < std::tie(b.kind, b.name);
    });
    return all;
}

}  // namespace crawford
