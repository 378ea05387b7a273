/// # Figure 10: what mechanics does to surface temperature and burn rate
///
/// The sandwich of figure 7 burns twice: as a rigid conductor, and with stress. Panel a shows the
/// steady surface temperature across it, panel b the mean burn rate (over the true length of the
/// surface) from ignition on.
///
/// Both runs share grid and step, so the difference is physics: heat taken by expansion, -beta T
/// div v with beta = 3 alpha K. How large it is hangs on that reading of beta, and on c_p being
/// kept as the capacity although the coupling supplies part of it: the change is that with c_p, as the
/// paper. Case model-form takes it apart and says how much is mechanics proper.

#include <fmt/format.h>

#include "base/build_info.hpp"
#include "cases/columns.hpp"
#include "cases/paper/ledger/evidence.hpp"
#include "cases/paper/ledger/readings.hpp"
#include "cases/registry.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;

constexpr auto thermal = "thermal", coupled = "coupled";

/// What the claims ask for.
namespace finds {
constexpr auto change_of_burn_rate = "mean burn rate changed with c_p, as the paper";
constexpr auto of_binder = "temperature at the centre of the binder";
constexpr auto of_AP = "temperature of the surface amid AP";
std::string of(const std::string& run, const std::string& what) {
    return run + ": " + what;
}
}  // namespace finds

void add(Outcome& outcome, const std::string& name, const Burn& burn) {
    const SurfaceLine surface = surface_line(burn.last);
    const int top = burn.last.temperature.rows() - 1;
    const int side = burn.last.temperature.columns() - 1;
    const double rate = burn.mean_burn_rate.back();
    outcome.figure
        .table("surface_" + name,
               {{"x", "um", scaled(surface.x, um)}, {"T_s", "K", surface.temperature}})
        .table("rate_" + name, {{"t", "ms", scaled(burn.time, ms)},
                                {"mean r_b", "cm/s", scaled(burn.mean_burn_rate, cm / s)}});
    outcome.findings.push_back(
        {finds::of(name, "mean burn rate over the arc"), rate / (cm / s), "cm/s"});
    outcome.findings.push_back(
        {finds::of(name, "regression rate"), burn.regression_rate.back() / (cm / s), "cm/s"});
    outcome.findings.push_back(
        {finds::of(name, finds::of_binder), burn.last.temperature(0, top), "K"});
    outcome.findings.push_back(
        {finds::of(name, finds::of_AP), burn.last.temperature(side, top), "K"});
    outcome.scenes.push_back(burn.scene);
}

Outcome fig10(const Request& request) {
    const Scene scene = burning_sandwich(request.fidelity, false);
    const auto rigid = kept_burn(scene, request);
    const auto with_stress = kept_burn(burning_sandwich(request.fidelity, true), request);
    Outcome outcome{reports::Figure("fig10", request.out), {}, {}};
    add(outcome, thermal, *rigid);
    add(outcome, coupled, *with_stress);
    const double ratio = with_stress->mean_burn_rate.back() / rigid->mean_burn_rate.back();
    outcome.findings.push_back({finds::change_of_burn_rate, 100.0 * (ratio - 1.0), "%"});
    outcome.figure
        .caption({.grid = grid_text(scene), .step = step_text(scene), .revision = revision()})
        .panel("a")
        .panel("b");
    return outcome;
}

reports::LedgerRow cooling(const ledger::Evidence& evidence, const std::string& as_read) {
    const auto found = evidence.findings_of("fig10");
    const auto change = [&](const std::string& what) {
        return found(finds::of(coupled, what)) - found(finds::of(thermal, what));
    };
    const double binder = change(finds::of_binder), ap = change(finds::of_AP);
    return reports::judged(reports::Statement{
        "mechanics cools the surface, binder more than AP", "Fig. 10a", "fig10",
        "a drop is observed, much higher in the binder",
        fmt::format("{:+.2f} K amid the strip, {:+.2f} K amid AP", binder, ap), as_read,
        binder < 0.0 && ap < 0.0 && binder < ap,
        "Both must fall, binder by more. Case model-form says how much of it is c_p counted "
        "twice."});
}

reports::LedgerRow slowing(const ledger::Evidence& evidence, const std::string& as_read) {
    const double change = evidence.finding("fig10", finds::change_of_burn_rate);
    double with_c_v = 0.0;
    for (const auto& other :
         ledger::others(evidence.sandwich_readings, ledger::quantity::change_of_burn_rate))
        if (other.reading.starts_with("c_v (")) with_c_v = other.value;
    return reports::judged(reports::Statement{
        "mechanics slows the burning of the sandwich", "Fig. 10b", "fig10",
        "causes a drop in the propellant burn rate", fmt::format("{:+.2f} %", change), as_read,
        change < 0.0,
        fmt::format("With c_v in place of c_p {:+.2f} %: the paper's sign is right, its size hangs "
                    "on a heat capacity counted twice.",
                    with_c_v)});
}

ledger::Rows claims(const ledger::Evidence& evidence) {
    const std::string as_read = "3 alpha K, c_p, strip of 60 um";
    return {cooling(evidence, as_read), slowing(evidence, as_read)};
}

const Registered here{
    {.name = "fig10",
     .figure = "Fig. 10",
     .shows = "sandwich: surface temperature and burn rate",
     .physics = {physics::heat, physics::burning, physics::coupling, physics::sandwich},
     .cost = {.draft = 8.0, .paper = 80.0},
     .draw = fig10,
     .burns =
         [](Fidelity f) {
             return std::vector{burning_sandwich(f, false), burning_sandwich(f, true)};
         },
     .claims = claims,
     .claims_rest_on = LedgerRuns::sandwich}};

}  // namespace

}  // namespace crawford
