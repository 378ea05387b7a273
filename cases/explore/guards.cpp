/// # Guards: is any answer wrong without a word, or any refused that is right?
///
/// Settings far from the paper's, each burnt as it is asked for and again much finer. An answer is
/// *wrong* where burnt depth or regression rate is more than 2 % off from that. A wrong answer must
/// have been refused or remarked on (docs/limits.md); what is refused must fail or be wrong when it is
/// burnt all the same; and what advice names a step must be right with that step.
///
/// Each study is one kind of setting, each setting a record of its own (scene, what was said, how far
/// it is off), and their gates count what became of them. Where the finer run does not burn either,
/// nothing can be judged.

#include <string>
#include <vector>

#include "cases/explore/extreme_scenes.hpp"
#include "cases/explore/judged_burn.hpp"
#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "solver/scene/write_scene.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::at_least;
using reports::at_most;

constexpr auto settings = "settings";
constexpr auto wrong_silently = "wrong without a word";
constexpr auto refused_right = "refused though right";
constexpr auto in_vain = "advice that does not help";

/// What became of one setting: 1 where it holds.
reports::Measurement standing(const Judged& judged) {
    const bool is_wrong = judged.can_be_judged && judged.error > wrong;
    const bool is_right = judged.can_be_judged && !is_wrong;
    const bool is_refused = judged.found.refused;
    const bool is_silent = judged.found.said.empty();
    const auto holds = [](bool is) { return is ? 1.0 : 0.0; };
    return reports::Measurement()
        .value(settings, 1.0)
        .value("off", judged.can_be_judged ? judged.error : 0.0)
        .value("right", holds(is_right && is_silent))
        .value("remarked or failed", holds(!is_silent && !is_refused))
        .value("refused", holds(is_refused))
        .value("not to be judged", holds(!judged.can_be_judged))
        .value(wrong_silently, holds(is_wrong && is_silent))
        .value(refused_right, holds(is_refused && is_right))
        .value(in_vain, holds(judged.misled));
}

reports::Study kind(const std::string& name, const std::vector<Scene>& scenes, int least) {
    reports::Study study("guards, " + name);
    study.lists("setting", int(scenes.size()))
        .covers({term::pyrolysis, term::time_step})
        .run([scenes](reports::Record& record) {
            const Scene& scene = scenes.at(size_t(record.setting.count("setting") - 1));
            record.scenes = {to_toml(scene)};
            const Judged judged = judge(scene);
            record.said = judged.found.said;
            record.found = standing(judged);
        })
        .total(settings, at_least(least), "all that were meant were tried")
        .total(wrong_silently, at_most(0), "every answer that is 2 % off has been spoken of")
        .total(refused_right, at_most(0), "what is refused fails or is wrong")
        .total(in_vain, at_most(0), "the step that a refusal names gives a right answer");
    return study;
}

std::vector<Scene> slabs() {
    std::vector<Scene> all;
    for (const Material& material : propellant())
        for (const double flux : {0.2, 0.3, 0.5, 1.0, 2.0, 5.0, 10.0})
            for (const double step : {20.0 * us, 80.0 * us, 320.0 * us, 1000.0 * us})
                for (const Stepping scheme : {Stepping::euler, Stepping::bdf2}) {
                    Scene& scene = all.emplace_back(burning_slab(material, flux));
                    scene.time.step = step;
                    scene.time.scheme = scheme;
                }
    return all;
}

std::vector<Scene> windows() {
    std::vector<Scene> all;
    for (const Material& material : propellant())
        for (const double depth : {50.0 * um, 100.0 * um, 200.0 * um, 480.0 * um, 2000.0 * um})
            for (const int rows : {4, 8, 16, 48}) {
                Scene& scene = all.emplace_back(burning_slab(material, 1.0));
                scene.domain.depth = depth;
                scene.domain.ny = rows;
            }
    return all;
}

std::vector<Scene> coupled_slabs() {
    std::vector<Scene> all;
    for (const Material& material : propellant())
        for (const double expansion : {0.5, 1.0, 1.5})
            for (const Coupling coupling : {Coupling::adiabatic, Coupling::lagged})
                for (const Stepping scheme : {Stepping::euler, Stepping::bdf2})
                    for (const ThermalStress work :
                         {ThermalStress::three_alpha_bulk, ThermalStress::alpha_bulk})
                        for (const double step : {40.0 * us, 120.0 * us}) {
                            Material swelling = material;
                            swelling.thermal_expansion *= expansion;
                            Scene& scene = all.emplace_back(burning_slab(swelling, 1.0));
                            scene.physics.mechanics = true;
                            scene.domain.ny = 48;
                            scene.numerics.coupling = coupling;
                            scene.numerics.stress_work = work;
                            scene.time.scheme = scheme;
                            scene.time.step = step;
                        }
    return all;
}

std::vector<Scene> sandwiches() {
    std::vector<Scene> all;
    for (const int columns : {16, 32})
        for (const double flux : {0.5, 1.0, 4.0})
            for (const double step : {40.0 * us, 160.0 * us, 500.0 * us})
                all.emplace_back(half_sandwich(columns, flux)).time.step = step;
    return all;
}

Scene coupled_sandwich() {
    Scene scene = half_sandwich(16, 1.0);
    scene.physics.mechanics = true;
    return scene;
}

/// What was found before there were guards: burnt wrong without a word, or refused needlessly.
std::vector<Scene> once_wrong() {
    std::vector<Scene> all;
    Scene& lagged = all.emplace_back(coupled_sandwich());  // alternates at 0.22 cm/s
    lagged.time.scheme = Stepping::bdf2;
    lagged.numerics.coupling = Coupling::lagged;
    Scene& split = all.emplace_back(coupled_sandwich());  // unequal betas
    split.numerics.stress_work = ThermalStress::alpha_bulk;
    for (const double pressure : {20.0 * MPa, 30.0 * MPa, 100.0 * MPa})  // the first load
        all.emplace_back(coupled_sandwich()).surface.pressure = pressure;
    for (const double tolerance : {1e-3, 1e-2})  // stopped by its change, not by its error
        all.emplace_back(half_sandwich(64, 1.0)).numerics.heat_tolerance = tolerance;
    all.emplace_back(half_sandwich(64, 10.0)).time.step = 10.0 * us;  // a zigzag surface
    all.emplace_back(burning_slab(ammonium_perchlorate(), 1.0)).time.step = 1.0 * ms;
    Material light = ammonium_perchlorate();
    light.density *= 1e-3;
    all.push_back(burning_slab(light, 1.0));
    for (const double heat : {0.44, 0.47, 0.8, 2.0}) {  // [MJ/kg]; the onset is 0.457
        Material exothermic = ammonium_perchlorate();
        exothermic.heat_of_reaction = heat * 1e6;
        all.push_back(burning_slab(exothermic, 1.0));
    }
    return all;
}

std::vector<reports::Study> studies() {
    return {kind("slabs over flux, step and scheme", slabs(), 112),
            kind("windows over depth and rows", windows(), 40),
            kind("coupled slabs over expansion and readings", coupled_slabs(), 96),
            kind("rigid sandwiches over columns, flux and step", sandwiches(), 18),
            kind("what once burnt wrong", once_wrong(), 14)};
}

const Registered here{{.name = "guards",
                       .figure = "-",
                       .shows = "settings at the extremes: none wrong without a word",
                       .physics = {physics::heat, physics::coupling, physics::slab},
                       .cost = {.verify = 120.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
