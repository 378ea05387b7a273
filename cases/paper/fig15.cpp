/// # Figure 15: what mechanics does to the burning of a pack
///
/// The pack of figure 13 burns twice: as a rigid conductor, and with stress. Panel a shows the
/// largest temperature, panel b the burn rate averaged over the true length of the surface. Dotted
/// lines are means from 20 ms on, where they begin: before, the first thermal layer is still
/// forming. The mean over the whole run, ignition and all, is given beside them.
///
/// Both runs share grid and step, so the difference is physics: heat taken by expansion, -beta T
/// div v with beta = 3 alpha K, while c_p is kept as the capacity although the coupling supplies
/// part of it. The rates rise and fall as discs come to the surface and burn away: the spread in
/// time belongs to the pack, not to the solver. It is one pack; others of the same discs have other
/// means.

#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "base/build_info.hpp"
#include "cases/columns.hpp"
#include "cases/registry.hpp"
#include "cases/scene_text.hpp"
#include "cases/scenes/pack.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;

double mean_of_all(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// Findings of one run; returns mean temperature [K] and mean burn rate [m/s].
std::pair<Course, Course> add(Outcome& outcome, const std::string& name, const Burn& burn) {
    const Course temperature = course(burn.time, burn.largest_temperature);
    const Course rate = course(burn.time, burn.mean_burn_rate);
    outcome.figure
        .table(name, {{"t", "ms", scaled(burn.time, ms)},
                      {"largest T", "K", burn.largest_temperature},
                      {"mean r_b", "cm/s", scaled(burn.mean_burn_rate, cm / s)}})
        .set("temperature_" + name, temperature.mean)
        .set("rate_" + name, rate.mean / (cm / s));
    const auto find = [&](const std::string& what, double value, const std::string& unit) {
        outcome.findings.push_back({name + ": " + what, value, unit});
    };
    find("largest temperature, mean from 20 ms on", temperature.mean, "K");
    find("largest temperature, standard deviation in time", temperature.deviation, "K");
    find("largest temperature, mean of the whole run", mean_of_all(burn.largest_temperature), "K");
    find("mean burn rate, mean from 20 ms on", rate.mean / (cm / s), "cm/s");
    find("mean burn rate, standard deviation in time", rate.deviation / (cm / s), "cm/s");
    find("mean burn rate, mean of the whole run", mean_of_all(burn.mean_burn_rate) / (cm / s),
         "cm/s");
    outcome.scenes.push_back(burn.scene);
    return {temperature, rate};
}

Outcome fig15(const Request& request) {
    const Scene scene = burning_pack(request.fidelity);
    Outcome outcome{reports::Figure("fig15", request.out, "cases/paper/fig15.gp"), {}, {}};
    const auto thermal =
        add(outcome, "thermal",
            *kept_burn(burning_pack(request.fidelity, {.mechanics = false}), request));
    const auto coupled = add(outcome, "coupled", *kept_burn(scene, request));
    outcome.findings.push_back(
        {"largest temperature changed by mechanics", coupled.first.mean - thermal.first.mean, "K"});
    outcome.findings.push_back({"mean burn rate changed by mechanics",
                                100.0 * (coupled.second.mean / thermal.second.mean - 1.0), "%"});
    outcome.figure.set("since", burning_since / ms)
        .set("until", scene.time.end / ms)
        .caption({.grid = grid_text(scene),
                  .step = step_text(scene),
                  .revision = revision(),
                  .note = "dotted: mean from 20 ms on"});
    for (const char* panel : {"a", "b"})
        outcome.figure.panel(panel, reports::Format::svg, {.width = 760, .height = 400});
    return outcome;
}

const Registered here{
    {.name = "fig15",
     .figure = "Fig. 15",
     .shows = "pack: largest temperature and burn rate, with and without stress",
     .physics = {physics::heat, physics::burning, physics::coupling, physics::pack},
     .cost = {.draft = 15.0, .paper = 410.0},
     .draw = fig15,
     .burns = [](Fidelity f) {
         return std::vector{burning_pack(f), burning_pack(f, {.mechanics = false})};
     }}};

}  // namespace

}  // namespace crawford
