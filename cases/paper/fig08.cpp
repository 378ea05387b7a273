/// # Figure 8: surface of the burning sandwich, column by column finer
///
/// Surface temperature and profile of the sandwich of figure 7 for grids of 32 to 256 columns, the
/// rows kept. The curves lie close but do not settle as fast as lines on paper suggest: beside the
/// interface the surface burns a notch that every grid makes one cell wide at first. Differences
/// between successive grids are given beside the figure (case "sandwich-refinement" says what they
/// are, "front-sandwich" how far a rigid sandwich is from its exact front).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/build_info.hpp"
#include "cases/columns.hpp"
#include "cases/paper/refined_sandwich.hpp"
#include "cases/registry.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;

/// Largest difference at the points of the coarser of two lines.
double largest_difference(const std::vector<double>& coarse, const std::vector<double>& fine) {
    const size_t ratio = (fine.size() - 1) / (coarse.size() - 1);
    double largest = 0.0;
    for (size_t i = 0; i < coarse.size(); ++i)
        largest = std::max(largest, std::abs(coarse[i] - fine[ratio * i]));
    return largest;
}

Outcome fig08(const Request& request) {
    const auto burns = refined_sandwich(request);
    Outcome outcome{reports::Figure("fig08", request.out), {}, {}};
    std::vector<SurfaceLine> lines;
    for (const auto& burn : burns) {
        lines.push_back(surface_line(burn->last));
        lines.back().height = above_first(lines.back().height);
        outcome.figure.table(fmt::format("nx{}", burn->scene.domain.nx),
                             {{"x", "um", scaled(lines.back().x, um)},
                              {"T_s", "K", lines.back().temperature},
                              {"height above the edge", "um", scaled(lines.back().height, um)}});
        outcome.scenes.push_back(burn->scene);
    }
    std::string grids;
    for (const auto& burn : burns) grids += fmt::format("{} ", burn->scene.domain.nx);
    for (size_t k = 0; k + 1 < burns.size(); ++k) {
        const std::string pair =
            fmt::format("{} against {} columns: largest difference of ", burns[k]->scene.domain.nx,
                        burns[k + 1]->scene.domain.nx);
        outcome.findings.push_back(
            {pair + "T_s", largest_difference(lines[k].temperature, lines[k + 1].temperature),
             "K"});
        outcome.findings.push_back({pair + "the profile",
                                    largest_difference(lines[k].height, lines[k + 1].height) / um,
                                    "um"});
    }
    outcome.figure.set("grids", grids)
        .caption({.grid = grids_text(burns),
                  .step = step_text(burns.back()->scene),
                  .revision = revision()})
        .panel("a")
        .panel("b");
    return outcome;
}

const Registered here{
    {.name = "fig08",
     .figure = "Fig. 8",
     .shows = "sandwich: surface temperature and profile on finer grids",
     .physics = {physics::heat, physics::burning, physics::grid, physics::sandwich},
     .cost = {.draft = 8.0, .paper = 370.0},
     .draw = fig08,
     .burns = [](Fidelity fidelity) { return refined_scenes(fidelity); }}};

}  // namespace

}  // namespace crawford
