/// # Figure 10: what mechanics does to surface temperature and burn rate
///
/// The sandwich of figure 7 burns twice: as a rigid conductor, and with stress. Panel a shows the
/// steady surface temperature across it, panel b the mean burn rate (over the true length of the
/// surface) from ignition on.
///
/// Both runs share grid and step, so the difference is physics: heat taken by expansion, -beta T
/// div v with beta = 3 alpha K. How large it is hangs on that reading of beta, and on c_p being
/// kept as the capacity although the coupling supplies part of it.

#include "base/build_info.hpp"
#include "cases/columns.hpp"
#include "cases/registry.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;

void add(Outcome& outcome, const std::string& name, const Burn& burn) {
    const SurfaceLine surface = surface_line(burn.last);
    const double centre = burn.last.temperature(0, burn.last.temperature.rows() - 1);
    const double rate = burn.mean_burn_rate.back();
    outcome.figure
        .table("surface_" + name,
               {{"x", "um", scaled(surface.x, um)}, {"T_s", "K", surface.temperature}})
        .table("rate_" + name, {{"t", "ms", scaled(burn.time, ms)},
                                {"mean r_b", "cm/s", scaled(burn.mean_burn_rate, cm / s)}});
    outcome.findings.push_back({name + ": mean burn rate", rate / (cm / s), "cm/s"});
    outcome.findings.push_back({name + ": temperature at the centre of the binder", centre, "K"});
    outcome.scenes.push_back(burn.scene);
}

Outcome fig10(const Request& request) {
    const Scene scene = burning_sandwich(request.fidelity, false);
    const auto thermal = kept_burn(scene, request);
    const auto coupled = kept_burn(burning_sandwich(request.fidelity, true), request);
    Outcome outcome{reports::Figure("fig10", request.out, "cases/paper/fig10.gp"), {}, {}};
    add(outcome, "thermal", *thermal);
    add(outcome, "coupled", *coupled);
    const double ratio = coupled->mean_burn_rate.back() / thermal->mean_burn_rate.back();
    outcome.findings.push_back({"mean burn rate changed by mechanics", 100.0 * (ratio - 1.0), "%"});
    outcome.figure
        .caption({.grid = grid_text(scene), .step = step_text(scene), .revision = revision()})
        .panel("a")
        .panel("b");
    return outcome;
}

const Registered here{
    {.name = "fig10",
     .figure = "Fig. 10",
     .shows = "sandwich: surface temperature and burn rate",
     .physics = {physics::heat, physics::burning, physics::coupling, physics::sandwich},
     .cost = {.draft = 8.0, .paper = 80.0},
     .draw = fig10,
     .burns = [](Fidelity f) {
         return std::vector{burning_sandwich(f, false), burning_sandwich(f, true)};
     }}};

}  // namespace

}  // namespace crawford
