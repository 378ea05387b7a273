#include "cases/paper/ledger/readings.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "base/errors.hpp"

namespace crawford::ledger {

namespace {

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
    {"no viscosity at corners", {"numerics.viscous_time=0 s"}}};

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
    std::erase_if(set, [](const std::string& key) { return key.starts_with("numerics."); });
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

/// The numbers of a matrix from a burn with and one without mechanics.
using Numbers = std::vector<double> (*)(const Burn& coupled, const Burn& rigid);

reports::ReadingMatrix matrix(const Subject& subject, const Resolution& resolution,
                              const std::vector<Reading>& readings, const Request& request,
                              std::vector<reports::Quantity> quantities, Numbers numbers) {
    reports::ReadingMatrix matrix;
    matrix.grid = text(resolution);
    matrix.quantities = std::move(quantities);
    for (const Reading& reading : readings) {
        reports::ReadingRun run{.reading = reading.name, .set = reading.set};
        try {
            const auto coupled = kept_burn(subject.coupled(resolution, reading.set), request);
            const auto rigid = kept_burn(subject.rigid(resolution, rigid_set(reading)), request);
            run.values = numbers(*coupled, *rigid);
        } catch (const NumericalFailure& failure) {
            run.failure = failure.what();
            run.values.assign(matrix.quantities.size(), std::numeric_limits<double>::quiet_NaN());
        }
        run.distance = distance(matrix.quantities, run.values);
        matrix.runs.push_back(std::move(run));
    }
    return matrix;
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

}  // namespace

std::vector<Reading> pack_readings() {
    return readings(of_a_pack);
}

std::vector<Reading> sandwich_readings() {
    return readings(of_a_sandwich);
}

std::vector<Scene> scenes_of(const Subject& subject, const Resolution& resolution,
                             const std::vector<Reading>& readings) {
    std::vector<Scene> scenes;
    for (const Reading& reading : readings) {
        scenes.push_back(subject.coupled(resolution, reading.set));
        scenes.push_back(subject.rigid(resolution, rigid_set(reading)));
    }
    return scenes;
}

reports::ReadingMatrix pack_matrix(const Resolution& resolution, const Request& request) {
    auto found = matrix(Subject("pack.toml"), resolution, pack_readings(), request,
                        {{"burn rate, rigid", "cm/s", 0.449},
                         {"burn rate", "cm/s", 0.42},
                         {"change of burn rate", "%", 100.0 * (0.42 / 0.449 - 1.0)},
                         {"rise of largest T, rigid", "K", 975.9 - cold},
                         {"rise of largest T", "K", 965.4 - cold},
                         {"largest strain", "-", 0.316},
                         {"strain over 5 um", "-", {}}},
                        numbers_of_pack);
    found.title = "burning pack: means of the whole run (Fig. 15, 16)";
    return found;
}

reports::ReadingMatrix sandwich_matrix(const Resolution& resolution, const Request& request) {
    auto found = matrix(Subject("sandwich.toml"), resolution, sandwich_readings(), request,
                        {{"burn rate, rigid", "cm/s", {}},
                         {"burn rate", "cm/s", {}},
                         {"change of burn rate", "%", {}},
                         {"change of T amid the strip", "K", {}},
                         {"largest strain", "-", 0.5},
                         {"strain over 5 um", "-", {}},
                         {"height of the profile", "um", 8.0},
                         {"outward displacement", "um", {}}},
                        numbers_of_sandwich);
    found.title = "burning sandwich: the end of the run (Fig. 7, 10, 11)";
    return found;
}

}  // namespace crawford::ledger
