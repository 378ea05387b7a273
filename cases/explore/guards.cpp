/// # Guards: is any answer wrong without a word, or any refused that is right?
///
/// Settings far from the paper's, each burnt as it is asked for and again on at least twice the
/// columns and rows at half the step. An answer is *wrong* where burnt depth or regression rate is
/// more than 2 % off from that. A wrong answer must have been refused or remarked on
/// (docs/limits.md); what is refused must fail or be wrong when it is burnt all the same; and what
/// advice names a step must be right with that step.
///
/// Each study is one kind of setting, and counts what became of them. Where the finer run does not
/// burn either, nothing can be judged.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "solver/guards/predicted.hpp"
#include "solver/guards/watch.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::at_least;
using reports::at_most;

constexpr double wrong = 0.02;
constexpr double flux_into_ap = 200.0 * cal / (s * cm2);

/// What a strand burner would tell, and what the program says of it.
struct Answer {
    double burnt = 0.0;  ///< [m]
    double rate = 0.0;   ///< regression rate at the end [m/s]
    bool burns = false;
    bool refused = false;
    std::string said;  ///< names of remarks, words of refusal and failure
};

/// Burns it in any case, also where it is refused.
Answer burn(const Scene& scene) {
    Answer answer;
    const auto say = [&](const Guards& guards) {
        for (const Guard& guard : guards) answer.said += guard.name + ' ';
    };
    const Guards before = predicted(scene);
    say(remarks(before));
    try {
        refuse(before);
    } catch (const InputError& refusal) {
        answer.refused = true;
        answer.said += refusal.what();
    }
    Simulation simulation(scene);
    Watch watch(simulation);
    const Observer listen = [&](const Simulation& now, double) {
        say(watch.record(now, now.summary()));
    };
    try {
        run_to_end(simulation, {listen});
    } catch (const NumericalFailure& failure) {
        answer.said += failure.what();
        return answer;
    }
    answer.burns = true;
    answer.burnt = -mean_height(simulation.grid(), simulation.state().surface);
    answer.rate = simulation.summary().regression_rate;
    return answer;
}

/// At least twice the columns and rows at half the step, and more where that is too coarse itself:
/// heats of ten times the paper's burn ten times as fast. The coupling is the one that holds for any
/// coupling number.
Scene finer(Scene scene) {
    if (scene.domain.nx > 1) scene.domain.nx *= 2;
    scene.domain.ny = std::max(2 * scene.domain.ny, 96);
    const double longest = scene.surface.heat_flux[0] > 2.0 * flux_into_ap ? 5.0 * us : 20.0 * us;
    scene.time.step /= std::max(2.0, std::ceil(scene.time.step / longest));
    scene.numerics.coupling = Coupling::adiabatic;
    constexpr double deep = 400.0 * um;
    if (scene.domain.depth < deep) {
        scene.domain.ny = int(std::ceil(scene.domain.ny * deep / scene.domain.depth));
        scene.domain.depth = deep;
    }
    return scene;
}

/// The scene with the step that the words advise, if they name one: "reduce time.step to 7.6 us".
std::optional<Scene> advised(Scene scene, const std::string& said) {
    const std::string advice = "reduce time.step to ";
    const size_t at = said.rfind(advice);
    if (at == std::string::npos) return {};
    scene.time.step = std::stod(said.substr(at + advice.size())) * us;
    return scene;
}

double off(const Answer& found, const Answer& right) {
    if (!found.burns) return 1.0;
    return std::max(std::abs(found.burnt / right.burnt - 1.0),
                    std::abs(found.rate / right.rate - 1.0));
}

/// What became of the settings of one kind.
struct Count {
    int settings = 0, right = 0, said = 0, refused = 0, unjudged = 0;
    int wrong_without_a_word = 0, right_but_refused = 0, advised_in_vain = 0;

    void add(const Scene& scene) {
        ++settings;
        const Answer found = burn(scene);
        const Answer truth = burn(finer(scene));
        if (!truth.burns || truth.burnt < 1.0 * um) {
            ++unjudged;  // nor does the finer one burn, or it is not yet alight
            return;
        }
        const bool is_wrong = off(found, truth) > wrong;
        right += found.said.empty() && !is_wrong ? 1 : 0;
        said += !found.said.empty() && !found.refused ? 1 : 0;
        refused += found.refused ? 1 : 0;
        wrong_without_a_word += is_wrong && found.said.empty() ? 1 : 0;
        right_but_refused += found.refused && !is_wrong ? 1 : 0;
        if (!found.refused) return;
        if (const auto better = advised(scene, found.said)) {
            const Answer helped = burn(*better);
            advised_in_vain += helped.refused || off(helped, truth) > wrong ? 1 : 0;
        }
    }
};

constexpr auto settings = "settings";
constexpr auto wrong_silently = "wrong without a word";
constexpr auto refused_right = "refused though right";
constexpr auto in_vain = "advice that does not help";

reports::Study kind(const std::string& name, const std::function<std::vector<Scene>()>& scenes,
                    int least) {
    reports::Study study("guards, " + name);
    study.refines("kinds", {1})
        .covers({term::pyrolysis, term::time_step})
        .measure([scenes](int) {
            Count count;
            for (const Scene& scene : scenes()) count.add(scene);
            return reports::Measurement(1.0)
                .value(settings, count.settings)
                .value("right", count.right)
                .value("remarked or failed", count.said)
                .value("refused", count.refused)
                .value("not to be judged", count.unjudged)
                .value(wrong_silently, count.wrong_without_a_word)
                .value(refused_right, count.right_but_refused)
                .value(in_vain, count.advised_in_vain);
        })
        .bound(settings, 1, at_least(least), "all that were meant were tried")
        .bound(wrong_silently, 1, at_most(0), "every answer that is 2 % off has been spoken of")
        .bound(refused_right, 1, at_most(0), "what is refused fails or is wrong")
        .bound(in_vain, 1, at_most(0), "the step that a refusal names gives a right answer");
    return study;
}

Scene slab(const Material& material, double flux) {
    Scene scene;
    scene.domain = {.width = 5.0 * um, .depth = 480.0 * um, .nx = 1, .ny = 96, .clustering = 2.0};
    scene.morphology.materials = {material};
    scene.physics = {.mechanics = false, .reference_map = false};
    scene.surface = {.pressure = 2.0 * MPa, .heat_flux = {flux * flux_into_ap}};
    scene.time = {.step = 40.0 * us, .end = 40.0 * ms};
    return scene;
}

const std::vector<Material>& propellant() {
    static const std::vector<Material> both{ammonium_perchlorate(), htpb_binder()};
    return both;
}

std::vector<Scene> slabs() {
    std::vector<Scene> all;
    for (const Material& material : propellant())
        for (const double flux : {0.2, 0.3, 0.5, 1.0, 2.0, 5.0, 10.0})
            for (const double step : {20.0 * us, 80.0 * us, 320.0 * us, 1000.0 * us})
                for (const Stepping scheme : {Stepping::euler, Stepping::bdf2}) {
                    Scene& scene = all.emplace_back(slab(material, flux));
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
                Scene& scene = all.emplace_back(slab(material, 1.0));
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
                            Scene& scene = all.emplace_back(slab(swelling, 1.0));
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
            for (const double step : {40.0 * us, 160.0 * us, 500.0 * us}) {
                Scene& scene = all.emplace_back(slab(ammonium_perchlorate(), flux));
                scene.domain = {.width = 240.0 * um,
                                .depth = 480.0 * um,
                                .nx = columns,
                                .ny = 48,
                                .clustering = 2.0,
                                .half = true};
                scene.morphology = {.shape = Sandwich{60.0 * um}, .materials = propellant()};
                scene.surface.heat_flux = {flux * flux_into_ap, 0.8 * flux * flux_into_ap};
                scene.time.step = step;
                scene.time.end = 20.0 * ms;
            }
    return all;
}

std::vector<reports::Study> studies() {
    return {kind("slabs over flux, step and scheme", slabs, 112),
            kind("windows over depth and rows", windows, 40),
            kind("coupled slabs over expansion and readings", coupled_slabs, 96),
            kind("rigid sandwiches over columns, flux and step", sandwiches, 18)};
}

const Registered here{{.name = "guards",
                       .figure = "-",
                       .shows = "settings at the extremes: none wrong without a word",
                       .physics = {physics::heat, physics::coupling, physics::slab},
                       .cost = {.verify = 120.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
