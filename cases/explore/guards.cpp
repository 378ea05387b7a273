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

#include <functional>
#include <string>
#include <vector>

#include "cases/explore/extreme_scenes.hpp"
#include "cases/explore/judged_burn.hpp"
#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::at_least;
using reports::at_most;

/// What became of the settings of one kind.
struct Count {
    int settings = 0, right = 0, said = 0, refused = 0, unjudged = 0;
    int wrong_without_a_word = 0, right_but_refused = 0, advised_in_vain = 0;

    void add(const Scene& scene) {
        ++settings;
        const Answer found = burn_in_any_case(scene);
        const Answer truth = burn_in_any_case(finer(scene));
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
            const Answer helped = burn_in_any_case(*better);
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
