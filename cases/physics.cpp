#include "cases/physics.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "cases/registry.hpp"
#include "cases/terms.hpp"

namespace crawford {

namespace physics {

namespace {

using Pair = std::pair<std::string_view, std::string_view>;

constexpr std::array<Pair, term::all.size()> headings{{
    {term::heat_storage, heat},
    {term::heat_convection, heat},
    {term::heat_conduction, heat},
    {term::heat_interface, heat},
    {term::stress_work, coupling},
    {term::gas_flux, burning},
    {term::reaction_flux, burning},
    {term::elasticity, stress},
    {term::stress_advection, stress},
    {term::jaumann_rotation, stress},
    {term::thermal_stress, coupling},
    {term::equilibrium, stress},
    {term::traction, stress},
    {term::support, stress},
    {term::elastic_interface, stress},
    {term::incompressibility, stress},
    {term::pyrolysis, burning},
    {term::surface_motion, burning},
    {term::surface_kink, burning},
    {term::surface_jump, burning},
    {term::map_advection, reference_map},
    {term::deformation, reference_map},
    {term::clustering, grid},
    {term::slope, grid},
    {term::grid_motion, grid},
    {term::moving_morphology, morphology},
    {term::time_step, time},
}};

static_assert(std::ranges::equal(term::all, headings, {}, {}, &Pair::first),
              "every term of the model has a heading, in the order of terms.hpp");

}  // namespace

std::string_view of_term(std::string_view term) {
    const auto* const found = std::ranges::find(headings, term, &Pair::first);
    return found == headings.end() ? std::string_view() : found->second;
}

}  // namespace physics

std::vector<std::string> physics_of(const Entry& entry) {
    std::set<std::string_view> found(entry.physics.begin(), entry.physics.end());
    if (entry.studies)
        for (const reports::Study& study : entry.studies())
            for (const std::string& term : study.covered()) found.insert(physics::of_term(term));
    std::vector<std::string> sorted;
    for (const auto* const heading : physics::all)
        if (found.contains(heading)) sorted.emplace_back(heading);
    return sorted;
}

}  // namespace crawford
