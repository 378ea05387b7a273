/// # Model form: how much of the lost burn rate is mechanics?
///
/// With stress the sandwich burns 7 % more slowly than as a rigid conductor, and so does the pack:
/// the solid expands, and expansion takes heat. How much of that is mechanics, and how much is one
/// specific heat counted twice?
///
/// The thermodynamics. Stress C:D - beta DT/Dt and the heat beta T div v come from one free energy,
/// whose balance of entropy is
///
///     rho c DT/Dt + beta T div v = div(kappa grad T),   c = c_v, at constant strain.
///
/// The paper puts c_p for c. With the mean pressure, Dp/Dt = beta DT/Dt - K div v, the same reads
///
///     rho (c + beta^2 T/(rho K)) DT/Dt = div(kappa grad T) + (beta/K) T Dp/Dt.
///
/// With c = c_v = c_p - beta^2 T/(rho K) the bracket is c_p. A solid that is free to expand keeps
/// its pressure and takes c_p, nothing else: for it the rigid conductor with c_p is exact. All that
/// mechanics can do to the temperature is the last term, the heat of compression where neighbours
/// keep the hot solid from expanding, and that warms. With c = c_p the bracket is too large: binder
/// takes 1568 J/(kg K) at 300 K and 2267 at 970 K where 1255 were meant.
///
/// A column that cannot widen rises by div v = (beta/P) DT/Dt, P = K + 4 mu/3, and takes
/// c_v + (K/P)(c_p - c_v). K/P is 0.9997 in binder, which hardly resists shear, and 0.47 in AP;
/// held in one direction only, as in plane strain, AP takes K/(K + mu/3) = 0.78 of the difference.
/// But AP's c_p - c_v is 2 J/(kg K) at 300 K, against the binder's 313.
///
/// What is computed. Four solids: a rigid conductor with c_p; one with stress and c_v at small
/// strain (K and mu times 100^2, alpha over 100: beta^2/K and the heat of compression stay, and
/// nothing moves); the same at its true strain; and the paper's, with c_p. What changes from the
/// first to the second is mechanics proper. From the second to the third it is stretch: rho is kept while
/// the solid swells, so rho (r_b + v) passes where rho r_b comes up, and more mass is heated than
/// burns. From the third to the last it is the capacity counted twice. Slabs have exact solutions
/// (reference/slab.hpp), to which the solver converges with c_v as with c_p
/// (cases/verify/coupled/heat_capacity.cpp); sandwich and pack burn on one grid with equal steps.
///
/// What it shows. (a) Heated evenly, a block of binder in the solver takes c_p if c_v stands in its
/// heat equation, and c_p + beta^2 T/(rho P) if c_p does. (b) Stress cools the slab of binder by
/// 297 K (beta = 3 alpha K; 74 K with alpha K, the paper's "about 80"): 213 K (44) are the
/// capacity, 84 K (31) the stretch, and mechanics proper warms by 0.1 K. AP, which resists its own
/// expansion, is warmed by 1.5 K. Where mass is conserved nothing is left of the stretch. (c to f)
/// Of the burn rate that sandwich and pack lose with c_p, as the paper has it (figures 10 and 15), most is
/// the capacity counted twice and the rest is stretch; mechanics proper, the first step alone, changes next
/// to nothing. The findings below have the parts and shares.
///
/// What not to conclude.
///
/// - That stress does not matter. This is about temperature; stress and strain are there, and what
///   they do to a propellant through cracks or debonding is not modelled.
/// - That c_v is the number to type in. If 1255 J/(kg K) were a c_v, the solid with stress would be
///   right, and the rigid conductor that it is compared with would need c_p, 25 % more in cold
///   binder. Only the comparison at one and the same c is wrong either way.
/// - That stretch is all lost mass. In two dimensions it holds the true change of shape as well.
/// - That the parts are exact to the last digit: they depend a little on the order in which the
///   assumptions are added, though their sum does not, and a pack that burns more slowly shows
///   other discs in the same time. beta^2 T/(rho K) reaches c_p at 1203 K in binder: Table 1 is
///   stretched far up there.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/build_info.hpp"
#include "cases/columns.hpp"
#include "cases/explore/four_solids.hpp"
#include "cases/registry.hpp"
#include "cases/scenes/pack.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/scenes/slab.hpp"
#include "cases/units.hpp"
#include "cases/verify/coupled/heated_block.hpp"
#include "reference/slab.hpp"

namespace crawford {

namespace {

using namespace units;
using reference::SlabConditions;
using reference::SlabModel;

constexpr double cold = 300.0;      // [K]
constexpr double heat = 8e8;        // [J/m^3]: 690 K of binder
constexpr int heating_steps = 256;  // to 1e-4 of the capacity

/// The slab of the paper's one-dimensional study, under `flux` cal/(s cm2).
Slab burning(const std::string& material, double flux) {
    return slab(material, {.cells = 1})
        .regressing(0.45 * cm / s)
        .heated(flux * cal / (s * cm2))
        .pressed(2.0 * MPa);
}

SlabConditions half_space(const Slab& slab) {
    SlabConditions conditions = slab.conditions(SlabModel::eulerian);
    conditions.depth = std::numeric_limits<double>::infinity();
    return conditions;
}

/// beta^2/K [J/(m^3 K^2)] with beta = 3 alpha K: rho (c_p - c_v)/T.
double expansion(const reference::Material& m) {
    return 9.0 * m.thermal_expansion * m.thermal_expansion * m.bulk_modulus;
}

/// Adds what the four solids have come to, and its parts, to the findings: temperatures in K, rates
/// in % of the rigid conductor's.
Parts find(Outcome& outcome, const std::string& what, const std::array<double, 4>& values,
           const std::string& unit) {
    for (size_t k = 0; k < values.size(); ++k)
        outcome.findings.push_back({fmt::format("{}: {}", what, solid_names[k]), values[k], unit});
    const Parts parts(values);
    const bool absolute = unit == "K";
    const auto add = [&](const std::string& part, double value) {
        outcome.findings.push_back({fmt::format("{}, changed {}", what, part),
                                    absolute ? value : 100.0 * value / values[0],
                                    absolute ? unit : "%"});
    };
    add("with c_p, as the paper", parts.whole);
    add("by the capacity counted twice", parts.twice);
    add("by stretch at constant density", parts.stretch);
    add("by mechanics proper", parts.mechanics);
    outcome.findings.push_back(
        {what + ", share of the capacity counted twice", 100.0 * parts.twice / parts.whole, "%"});
    return parts;
}

/// What a degree takes, at constant pressure and as the solver's block has it.
void add_capacity(Outcome& outcome) {
    const reference::Material m = reference::binder();
    reports::Column t{"T", "K", {}}, c_p{"c_p", "J/(kg K)", {}}, c_v{"c_v", "J/(kg K)", {}},
        as_read{"c_p and stress work", "J/(kg K)", {}};
    constexpr double spacing = 10.0;
    constexpr int count = 68;  // up to 970 K
    for (int i = 0; i < count; ++i) {
        const double at = cold + i * spacing;
        const double rise = expansion(m) * at / m.density;
        t.values.push_back(at);
        c_p.values.push_back(m.specific_heat);
        c_v.values.push_back(m.specific_heat - rise);
        as_read.values.push_back(m.specific_heat + rise * m.bulk_modulus / m.uniaxial_modulus());
    }
    outcome.figure.table("capacity", {t, c_p, as_read, c_v});
    for (const auto capacity : {HeatCapacity::constant_pressure, HeatCapacity::constant_volume}) {
        const Heating block = heat_evenly(htpb_binder(), capacity, heat, heating_steps);
        reports::Column mean{"T", "K", {}}, taken{"heat per degree", "J/(kg K)", {}};
        for (size_t k = 16; k < block.heat.size(); k += 16) {
            const double rise = block.temperature[k] - block.temperature[k - 16];
            mean.values.push_back(block.temperature[k] - rise / 2.0);
            taken.values.push_back((block.heat[k] - block.heat[k - 16]) / (m.density * rise));
        }
        const bool at_constant_pressure = capacity == HeatCapacity::constant_pressure;
        outcome.figure.table(at_constant_pressure ? "heated_c_p" : "heated_c_v", {mean, taken});
    }
}

/// The slab of binder below its surface.
void add_profile(Outcome& outcome, const std::string& name, const Slab& slab) {
    std::vector<double> y;
    for (int k = 0; k <= 120; ++k) y.push_back(-k * um);
    std::vector<reports::Column> columns{{"depth", "um", scaled(y, -um)}};
    const auto solids = four_solids(half_space(slab));
    for (size_t k = 0; k < solids.size(); ++k) {
        reports::Column column{std::string("T ") + solid_names[k], "K", {}};
        for (const auto& state : reference::Slab(solids[k]).states(y))
            column.values.push_back(state.temperature);
        columns.push_back(column);
    }
    outcome.figure.table(name, columns);
}

std::array<double, 4> each(const Slab& slab, double (reference::Slab::*value)() const) {
    std::array<double, 4> values{};
    const auto solids = four_solids(half_space(slab));
    for (size_t k = 0; k < solids.size(); ++k) values[k] = (reference::Slab(solids[k]).*value)();
    return values;
}

std::array<Scene, 4> sandwiches(Fidelity fidelity) {
    return four_solids(burning_sandwich(fidelity, false), burning_sandwich(fidelity, true));
}

std::array<Scene, 4> packs(Fidelity fidelity) {
    return four_solids(burning_pack(fidelity, {.mechanics = false}), burning_pack(fidelity));
}

/// As text of a figure, which takes % for the beginning of a format.
std::string percent(const Parts& parts, double rigid) {
    return fmt::format("{:+.1f} %%", 100.0 * parts.whole / rigid);
}

/// The bars of panel f: parts of a change, as shares of the whole.
class Bars {
public:
    void add(reports::Figure& figure, const std::string& of, const std::string& reading,
             const Parts& parts, const std::string& whole) {
        const size_t bar = columns_.front().values.size();
        const double values[] = {double(bar), 100.0 * parts.twice / parts.whole,
                                 100.0 * parts.stretch / parts.whole,
                                 100.0 * parts.mechanics / parts.whole};
        for (size_t c = 0; c < columns_.size(); ++c) columns_[c].values.push_back(values[c]);
        figure.set(fmt::format("bar_{}", bar), of)
            .set(fmt::format("reading_{}", bar), reading)
            .set(fmt::format("whole_{}", bar), whole);
    }
    const std::vector<reports::Column>& table() const { return columns_; }

private:
    std::vector<reports::Column> columns_{{"bar", "-", {}},
                                          {"capacity counted twice", "%", {}},
                                          {"stretch", "%", {}},
                                          {"mechanics proper", "%", {}}};
};

void add_slabs(Outcome& outcome, Bars& bars) {
    const Slab binder = burning("binder", 100.0);
    add_profile(outcome, "slab_three_alpha", binder);
    add_profile(outcome, "slab_alpha", Slab(binder).thermal_stress_alpha_k());
    for (const auto& [name, slab] : {std::pair{std::string("AP"), burning("AP", 200.0)},
                                     std::pair{std::string("binder"), binder}}) {
        const auto add = [&, &name = name](const std::string& reading, const Slab& read) {
            const Parts parts =
                find(outcome, fmt::format("slab of {}, {}: surface temperature", name, reading),
                     each(read, &reference::Slab::surface_temperature), "K");
            bars.add(outcome.figure, "slab of " + name, reading, parts,
                     fmt::format("{:+.3g} K", parts.whole));
        };
        add("α K", Slab(slab).thermal_stress_alpha_k());
        add("3 α K", slab);
        auto rates = each(
            Slab(slab).heated((name == "AP" ? 200.0 : 160.0) * cal / (s * cm2)).burning_by_law(),
            &reference::Slab::burn_rate);
        for (double& rate : rates) rate /= cm / s;
        find(outcome, "slab of " + name + " that burns by its law: burn rate", rates, "cm/s");
    }
}

using Burns = std::array<std::shared_ptr<const Burn>, 4>;

/// Burns the four solids.
Burns burn(Outcome& outcome, const std::string& name, const std::array<Scene, 4>& scenes,
           const Request& request) {
    Burns burns;
    for (size_t k = 0; k < scenes.size(); ++k) {
        const auto& burn = burns[k] = kept_burn(scenes[k], request);
        outcome.figure.table(name + "_" + solid_names[k],
                             {{"t", "ms", scaled(burn->time, ms)},
                              {"mean r_b", "cm/s", scaled(burn->mean_burn_rate, cm / s)},
                              {"largest T", "K", burn->largest_temperature}});
        outcome.scenes.push_back(scenes[k]);
    }
    return burns;
}

std::array<double, 4> each(const Burns& burns, double (*value)(const Burn&)) {
    std::array<double, 4> values{};
    std::ranges::transform(burns, values.begin(), [&](const auto& burn) { return value(*burn); });
    return values;
}

void add_sandwich(Outcome& outcome, Bars& bars, const Request& request) {
    const Burns burns = burn(outcome, "sandwich", sandwiches(request.fidelity), request);
    const auto rate = each(burns, [](const Burn& b) { return b.mean_burn_rate.back() / (cm / s); });
    const Parts parts = find(outcome, "sandwich: mean burn rate", rate, "cm/s");
    bars.add(outcome.figure, "sandwich", "3 α K", parts, percent(parts, rate[0]));
}

void add_pack(Outcome& outcome, Bars& bars, const Request& request) {
    const Burns burns = burn(outcome, "pack", packs(request.fidelity), request);
    const auto rate =
        each(burns, [](const Burn& b) { return course(b.time, b.mean_burn_rate).mean / (cm / s); });
    const auto hottest =
        each(burns, [](const Burn& b) { return course(b.time, b.largest_temperature).mean; });
    for (size_t k = 0; k < burns.size(); ++k)
        outcome.figure.set(std::string("rate_") + solid_names[k], rate[k])
            .set(std::string("hottest_") + solid_names[k], hottest[k]);
    const Parts parts = find(outcome, "pack: mean burn rate from 20 ms on", rate, "cm/s");
    find(outcome, "pack: largest temperature, mean from 20 ms on", hottest, "K");
    bars.add(outcome.figure, "pack", "3 α K", parts, percent(parts, rate[0]));
}

Outcome model_form(const Request& request) {
    Outcome outcome{reports::Figure("model_form", request.out), {}, {}};
    Bars bars;
    add_capacity(outcome);
    add_slabs(outcome, bars);
    add_sandwich(outcome, bars, request);
    add_pack(outcome, bars, request);
    outcome.figure.table("parts", bars.table());
    const Scene sandwich = sandwiches(request.fidelity).back();
    const Scene pack = packs(request.fidelity).back();
    outcome.figure.set("since", burning_since / ms)
        .set("until", pack.time.end / ms)
        .caption({.grid = fmt::format("sandwich {}; pack {}", grid_text(sandwich), grid_text(pack)),
                  .step = fmt::format("{}; {}", step_text(sandwich), step_text(pack)),
                  .revision = revision()});
    for (const char* panel : {"a", "b", "c", "d", "e"}) outcome.figure.panel(panel);
    outcome.figure.panel("f", reports::Format::svg, {.width = 760, .height = 440});
    return outcome;
}

std::vector<Scene> burns(Fidelity fidelity) {
    std::vector<Scene> all;
    for (const auto& four : {packs(fidelity), sandwiches(fidelity)})
        all.insert(all.end(), four.begin(), four.end());
    return all;
}

const Registered here{
    {.name = "model-form",
     .figure = "-",
     .shows = "how much of the lost burn rate is mechanics, how much c_p twice",
     .physics = {physics::heat, physics::coupling, physics::slab, physics::sandwich, physics::pack},
     .cost = {.draft = 60.0, .paper = 900.0},
     .draw = model_form,
     .burns = burns}};

}  // namespace

}  // namespace crawford
