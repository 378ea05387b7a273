/// # Figure 15: what mechanics does to the burning of a pack
///
/// The pack of figure 13 burns twice: as a rigid conductor, and with stress. Panel a shows the
/// largest temperature, panel b the burn rate averaged over the true length of the surface. Dotted
/// lines are means from 20 ms on, where they begin: before, the first thermal layer is still
/// forming. The mean over the whole run, ignition and all, is given beside them.
///
/// Both runs share grid and step, so the difference is physics: heat taken by expansion, -beta T
/// div v with beta = 3 alpha K, while c_p is kept as the capacity although the coupling supplies
/// part of it: the change is that with c_p, as the paper. Case model-form says how much is mechanics
/// proper. The rates rise and fall as discs come to the surface and burn away: the spread in
/// time belongs to the pack, not to the solver. It is one pack; others of the same discs have other
/// means.

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "base/build_info.hpp"
#include "cases/columns.hpp"
#include "cases/paper/ledger/pack_evidence.hpp"
#include "cases/paper/ledger/readings.hpp"
#include "cases/registry.hpp"
#include "cases/scene_text.hpp"
#include "cases/scenes/pack.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;

constexpr auto thermal = "thermal", coupled = "coupled";

/// What the claims ask for, of each run.
namespace finds {
constexpr auto temperature = "largest temperature, mean of the whole run";
constexpr auto later_temperature = "largest temperature, mean from 20 ms on";
constexpr auto burn_rate = "mean burn rate, mean of the whole run";
constexpr auto regression_rate = "regression rate";
constexpr auto later_burn_rate = "mean burn rate, mean from 20 ms on";
std::string of(const std::string& run, const std::string& what) {
    return run + ": " + what;
}
}  // namespace finds

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
        outcome.findings.push_back({finds::of(name, what), value, unit});
    };
    find(finds::later_temperature, temperature.mean, "K");
    find("largest temperature, standard deviation in time", temperature.deviation, "K");
    find(finds::temperature, ledger::mean_temperature.of(burn), "K");
    find(finds::later_burn_rate, rate.mean / (cm / s), "cm/s");
    find("mean burn rate, standard deviation in time", rate.deviation / (cm / s), "cm/s");
    find(finds::burn_rate, ledger::mean_burn_rate_of_all.of(burn), "cm/s");
    find(finds::regression_rate, ledger::regression_rate_of_all.of(burn), "cm/s");
    outcome.scenes.push_back(burn.scene);
    return {temperature, rate};
}

Outcome fig15(const Request& request) {
    const Scene scene = burning_pack(request.fidelity);
    Outcome outcome{reports::Figure("fig15", request.out), {}, {}};
    const auto rigid =
        add(outcome, thermal,
            *kept_burn(burning_pack(request.fidelity, {.mechanics = false}), request));
    const auto with_stress = add(outcome, coupled, *kept_burn(scene, request));
    outcome.findings.push_back({"largest temperature changed with c_p, as the paper",
                                with_stress.first.mean - rigid.first.mean, "K"});
    outcome.findings.push_back({"mean burn rate changed with c_p, as the paper",
                                100.0 * (with_stress.second.mean / rigid.second.mean - 1.0), "%"});
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

double difference(double with, double without) {
    return with - without;
}

double per_cent(double with, double without) {
    return 100.0 * (with / without - 1.0);
}

ledger::Rows temperatures(const ledger::Evidence& evidence) {
    using namespace ledger;
    using reports::half_digit, reports::judged;
    const auto found = evidence.findings_of("fig15");
    constexpr double cold = 300.0;  // [K]
    const double with = found(finds::of(coupled, finds::temperature));
    const double without = found(finds::of(thermal, finds::temperature));
    const double later = found(finds::of(coupled, finds::later_temperature));
    const double rigid_later = found(finds::of(thermal, finds::later_temperature));
    const auto as_others = [&](const char* rise, double since) {
        return before({since_20_ms, since}, plus(others(evidence.pack_readings, rise), cold));
    };
    return {judged({"mean of the largest temperature, thermal", "Fig. 15a", "fig15", "K", "975.9",
                    975.9, half_digit("975.9")},
                   {without, uncertainty(evidence, of_rigid_pack, mean_temperature), pack_as_read,
                    as_others(quantity::rigid_rise, rigid_later),
                    divergence(evidence, of_rigid_pack, mean_temperature, "x and y"), "{:.1f}"}),
            judged({"mean of the largest temperature, thermo-mechanical", "Fig. 15a", "fig15", "K",
                    "965.4", 965.4, half_digit("965.4")},
                   {with, uncertainty(evidence, of_pack, mean_temperature), pack_as_read,
                    as_others(quantity::rise, later),
                    divergence(evidence, of_pack, mean_temperature, "x and y"), "{:.1f}"}),
            judged({"their difference", "Fig. 15a", "fig15", "K", "-10.5", -10.5, 0.1},
                   {difference(with, without),
                    uncertainty_of_change(evidence, mean_temperature, difference),
                    pack_as_read,
                    {{since_20_ms, later - rigid_later}},
                    "Of two runs of one pack on one grid: what they share cancels.",
                    "{:.1f}"})};
}

ledger::Rows burn_rates(const ledger::Evidence& evidence) {
    using namespace ledger;
    using reports::half_digit, reports::judged;
    const auto found = evidence.findings_of("fig15");
    const double with = found(finds::of(coupled, finds::burn_rate));
    const double without = found(finds::of(thermal, finds::burn_rate));
    const double later = found(finds::of(coupled, finds::later_burn_rate));
    const double rigid_later = found(finds::of(thermal, finds::later_burn_rate));
    const auto& read = evidence.pack_readings;
    return {
        judged({"mean burn rate, thermal", "Fig. 15b", "fig15", "cm/s", "0.449", 0.449,
                half_digit("0.449")},
               {without, uncertainty(evidence, of_rigid_pack, mean_burn_rate_of_all), pack_as_read,
                before({since_20_ms, rigid_later}, others(read, quantity::rigid_burn_rate)),
                fmt::format("Over the arc; the regression rate is {:.4f}. From 20 ms on {:.4f}. "
                            "The specific heat is not printed, and the rate "
                            "goes roughly as its inverse.",
                            found(finds::of(thermal, finds::regression_rate)), rigid_later),
                "{:.4f}"}),
        judged({"mean burn rate, thermo-mechanical", "Fig. 15b", "fig15", "cm/s", "0.42", 0.42,
                half_digit("0.42")},
               {with, uncertainty(evidence, of_pack, mean_burn_rate_of_all), pack_as_read,
                before({since_20_ms, later}, others(read, quantity::burn_rate)),
                fmt::format("Over the arc; the regression rate is {:.4f}. From 20 ms on {:.4f}.",
                            found(finds::of(coupled, finds::regression_rate)), later),
                "{:.4f}"}),
        judged({"change of the burn rate by mechanics", "Fig. 15b", "fig15", "%", "-6.5",
                100.0 * (0.42 / 0.449 - 1.0), 100.0 * half_digit("0.42") / 0.449},
               {per_cent(with, without),
                uncertainty_of_change(evidence, mean_burn_rate_of_all, per_cent), pack_as_read,
                others(read, quantity::change_of_burn_rate),
                "With c_v in place of c_p most of it is gone: case model-form.", "{:.2f}"})};
}

ledger::Rows claims(const ledger::Evidence& evidence) {
    ledger::Rows rows = temperatures(evidence);
    std::ranges::move(burn_rates(evidence), std::back_inserter(rows));
    return rows;
}

const Registered here{
    {.name = "fig15",
     .figure = "Fig. 15",
     .shows = "pack: largest temperature and burn rate, with and without stress",
     .physics = {physics::heat, physics::burning, physics::coupling, physics::pack},
     .cost = {.draft = 15.0, .paper = 410.0},
     .draw = fig15,
     .burns =
         [](Fidelity f) {
             return std::vector{burning_pack(f), burning_pack(f, {.mechanics = false})};
         },
     .claims = claims,
     .claims_rest_on = LedgerRuns::pack}};

}  // namespace

}  // namespace crawford
