#include "cases/paper/ledger/readings.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "cases/units.hpp"

namespace crawford::ledger {

namespace {

using namespace units;

/// Choices that exclude each other, the one that Crawford takes first.
using Axis = std::vector<Reading>;

const Axis thermal_expansion = {
    {"3 alpha K"},
    {"alpha K", {"numerics.thermal_stress=alpha K", "numerics.stress_work=alpha K"}},
    {"3 alpha K, alpha K in the stress work", {"numerics.stress_work=alpha K"}}};
const Axis heat_capacity = {{"c_p"}, {"c_v", {"numerics.heat_capacity=c_v"}}};
const Axis specific_heat = {
    {"1255 J/(kg K)"},
    {"1000 J/(kg K)",
     {"materials.AP.specific_heat=1000 J/(kg K)", "materials.binder.specific_heat=1000 J/(kg K)"},
     true}};
const Axis surface_motion = {
    {"eq. 9"}, {"eq. 9 with material velocity", {"numerics.surface_motion=burning with material"}}};

/// What is tried alone, all else as Crawford takes it.
const std::vector<Reading> alone = {
    {"q_s in J/kg",
     {"materials.AP.heat_of_reaction=-47 J/kg", "materials.binder.heat_of_reaction=-100 J/kg"},
     true},
    {"q_s of AP and binder exchanged",
     {"materials.AP.heat_of_reaction=-100 kcal/kg",
      "materials.binder.heat_of_reaction=-47 kcal/kg"},
     true},
    {"q_s released",
     {"materials.AP.heat_of_reaction=47 kcal/kg", "materials.binder.heat_of_reaction=100 kcal/kg"},
     true},
    {"traction (0, -p_c)", {"surface.traction=vertical"}},
    {"clamped bottom", {"bottom.support=clamped"}},
    {"largest strain component", {"numerics.strain_norm=largest"}},
    {"q1 element", {"numerics.element=q1"}},
    {"no viscosity at corners", {"numerics.viscous_time=0 s"}},
    {"mean of the rates where materials meet", {"numerics.front=mean of materials"}, true}};

const std::vector<Reading> of_a_pack = {
    {"material carried by the map", {"morphology.indicator=reference map"}}};

const std::vector<Reading> of_a_sandwich = {{"strip of 30 um", {"morphology.strip=30 um"}, true},
                                            {"strip of 45 um", {"morphology.strip=45 um"}, true},
                                            {"strip of 90 um", {"morphology.strip=90 um"}, true},
                                            {"strip of 120 um", {"morphology.strip=120 um"}, true}};

Reading both(const Reading& a, const Reading& b) {
    Reading both = a;
    if (b.set.empty()) return both;
    both.name = a.set.empty() ? b.name : a.name + "; " + b.name;
    both.set.insert(both.set.end(), b.set.begin(), b.set.end());
    both.of_rigid = a.of_rigid || b.of_rigid;
    return both;
}

/// Every choice of one axis with every choice of the others.
std::vector<Reading> combined(const std::vector<Axis>& axes) {
    std::vector<Reading> all = {{"as read"}};
    for (const Axis& axis : axes) {
        std::vector<Reading> longer;
        for (const Reading& one : all)
            for (const Reading& choice : axis) longer.push_back(both(one, choice));
        all = std::move(longer);
    }
    return all;
}

std::vector<Reading> readings(const std::vector<Reading>& more) {
    auto all = combined({thermal_expansion, heat_capacity, specific_heat, surface_motion});
    all.insert(all.end(), alone.begin(), alone.end());
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// Keys that a rigid conductor has as well.
std::vector<std::string> rigid_set(const Reading& reading) {
    if (!reading.of_rigid) return {};
    std::vector<std::string> set = reading.set;
    std::erase_if(set, [](const std::string& key) {
        return key.starts_with("numerics.") && !key.starts_with("numerics.front");
    });
    return set;
}

double distance(const std::vector<reports::Quantity>& quantities,
                const std::vector<double>& values) {
    double squares = 0.0;
    int count = 0;
    for (size_t k = 0; k < values.size(); ++k) {
        if (!quantities[k].paper) continue;
        squares += std::pow(values[k] / *quantities[k].paper - 1.0, 2);
        ++count;
    }
    return std::sqrt(squares / count);
}

double change(double coupled, double rigid) {
    return 100.0 * (coupled / rigid - 1.0);
}

constexpr double cold = 300.0;  // [K]

std::vector<double> numbers_of_pack(const Burn& coupled, const Burn& rigid) {
    const double rate = mean_burn_rate_of_all.of(coupled);
    const double rigid_rate = mean_burn_rate_of_all.of(rigid);
    return {rigid_rate,
            rate,
            change(rate, rigid_rate),
            mean_temperature.of(rigid) - cold,
            mean_temperature.of(coupled) - cold,
            mean_strain.of(coupled),
            mean_strain_about_peak.of(coupled)};
}

std::vector<double> numbers_of_sandwich(const Burn& coupled, const Burn& rigid) {
    const double rate = last_burn_rate.of(coupled);
    const double rigid_rate = last_burn_rate.of(rigid);
    const int top = coupled.last.temperature.rows() - 1;
    return {rigid_rate,
            rate,
            change(rate, rigid_rate),
            coupled.last.temperature(0, top) - rigid.last.temperature(0, top),
            last_strain.of(coupled),
            last_strain_about_peak.of(coupled),
            height_of_profile.of(coupled),
            outward_displacement.of(coupled)};
}

std::vector<Scene> scenes_of(const Readings& of, const Reading& reading) {
    return {of.subject.coupled(of.resolution, reading.set),
            of.subject.rigid(of.resolution, rigid_set(reading))};
}

Run run_of(const Readings& of, const Reading& reading) {
    auto scenes = scenes_of(of, reading);
    const auto setting = with(reports::Setting().set("reading", reading.name), of.resolution);
    return {of.experiment, setting, scenes,
            [scenes, quantities = of.quantities, numbers = of.numbers](const Request& request) {
                const auto coupled = kept_burn(scenes[0], request);
                const auto rigid = kept_burn(scenes[1], request);
                const auto values = numbers(*coupled, *rigid);
                reports::Measurement found;
                for (size_t k = 0; k < values.size(); ++k)
                    found.value(quantities[k].name, reports::Amount{values[k], quantities[k].unit});
                return found;
            }};
}

/// Readings are compared on coarse grids with long steps: what they change is far more than what
/// those do, and there are many.
Resolution of_pack_readings(Fidelity fidelity) {
    if (fidelity == Fidelity::draft) return {40, 32, 100 * us, 0.04};
    return {60, 48, 100 * us, 0.135};
}

Resolution of_sandwich_readings(Fidelity fidelity) {
    if (fidelity == Fidelity::draft) return {16, 24, 160 * us, 0.04};
    return {32, 48, 80 * us, 0.1};
}

}  // namespace

Readings pack_readings(Fidelity fidelity) {
    return {.experiment = "pack-readings",
            .title = "burning pack: means of the whole run (Fig. 15, 16)",
            .subject = Subject("pack.toml"),
            .resolution = of_pack_readings(fidelity),
            .readings = readings(of_a_pack),
            .quantities = {{quantity::rigid_burn_rate, "cm/s", 0.449},
                           {quantity::burn_rate, "cm/s", 0.42},
                           {quantity::change_of_burn_rate, "%", 100.0 * (0.42 / 0.449 - 1.0)},
                           {quantity::rigid_rise, "K", 975.9 - cold},
                           {quantity::rise, "K", 965.4 - cold},
                           {quantity::largest_strain, "-", 0.316},
                           {quantity::strain_about_peak, "-", {}}},
            .numbers = numbers_of_pack};
}

Readings sandwich_readings(Fidelity fidelity) {
    return {.experiment = "sandwich-readings",
            .title = "burning sandwich: the end of the run (Fig. 7, 10, 11)",
            .subject = Subject("sandwich.toml"),
            .resolution = of_sandwich_readings(fidelity),
            .readings = readings(of_a_sandwich),
            .quantities = {{quantity::rigid_burn_rate, "cm/s", {}},
                           {quantity::burn_rate, "cm/s", {}},
                           {quantity::change_of_burn_rate, "%", {}},
                           {"change of T amid the strip", "K", {}},
                           {quantity::largest_strain, "-", 0.5},
                           {quantity::strain_about_peak, "-", {}},
                           {quantity::height_of_profile, "um", 8.0},
                           {"outward displacement", "um", {}}},
            .numbers = numbers_of_sandwich};
}

std::vector<Run> runs(const Readings& of) {
    std::vector<Run> runs;
    for (const Reading& reading : of.readings) runs.push_back(run_of(of, reading));
    return runs;
}

reports::ReadingMatrix matrix(const Readings& of, const Records& records) {
    reports::ReadingMatrix matrix{
        .title = of.title, .grid = text(of.resolution), .quantities = of.quantities};
    for (const Reading& reading : of.readings) {
        reports::ReadingRun run{.reading = reading.name, .set = reading.set};
        const reports::Record record = records(run_of(of, reading));
        for (const auto& quantity : of.quantities)
            run.values.push_back(record.found ? value(*record.found, quantity.name)
                                              : std::numeric_limits<double>::quiet_NaN());
        run.failure = record.ending.message;
        run.distance = distance(matrix.quantities, run.values);
        matrix.runs.push_back(std::move(run));
    }
    return matrix;
}

}  // namespace crawford::ledger
