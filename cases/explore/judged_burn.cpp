#include "cases/explore/judged_burn.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "base/errors.hpp"
#include "cases/explore/extreme_scenes.hpp"
#include "cases/units.hpp"
#include "solver/guards/predicted.hpp"
#include "solver/guards/watch.hpp"
#include "solver/run/loop.hpp"
#include "solver/scene/defaults.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

using namespace units;

namespace {

double number_of(const Guards& guards, const std::string& name) {
    const auto guard = std::ranges::find(guards, name, &Guard::name);
    return guard == guards.end() ? 0.0 : guard->value;
}

bool is_refused(const Scene& scene) {
    return std::ranges::any_of(predicted(resolved(scene)),
                               [](const Guard& guard) { return guard.beyond == Beyond::refusal; });
}

/// Rows for what a slab's layer needs, and no more than so many.
void refine_rows(Scene& scene) {
    constexpr double fine = 0.7;  // cell Peclet number
    constexpr int most = 800;
    const double peclet = number_of(predicted(resolved(scene)), "cell_peclet");
    if (peclet > fine)
        scene.domain.ny = std::max(scene.domain.ny,
                                   std::min(most, int(std::ceil(scene.domain.ny * peclet / fine))));
}

/// A window that its bottom does not cool, with rows as high as before if they need not be many.
void deepen(Scene& scene) {
    constexpr double enough = 8.0, most = 20.0;
    const double layers = number_of(predicted(resolved(scene)), "layers_in_window");
    if (layers <= 0.0 || layers >= enough) return;
    const double times = std::min(most, enough / layers);
    scene.domain.depth *= times;
    scene.domain.ny = int(std::ceil(scene.domain.ny * times));
}

/// Where a run ends that is asked for this [s]: equal steps may pass the end.
double reached(const Time& time) {
    return time.accuracy ? time.end : double(last_step(time)) * time.step;
}

void end_with_a_step(Time& time) {
    time.step = time.end / std::ceil(time.end / time.step);
}

/// A step that follows the burning, whatever the setting's own.
void choose_step(Scene& scene) {
    constexpr double probe = 20.0 * us;  // also where nothing is known of the burning
    constexpr double fewest = 400.0, most = 25'000.0;
    scene.time.step = probe;
    const Guards numbers = predicted(resolved(scene));
    constexpr double followed = 0.03, crossed = 0.4;
    const double front = number_of(numbers, "front_coupling") / followed;
    const double rows = number_of(numbers, "crossing_y") / crossed;
    if (front > 0.0) scene.time.step = probe / std::max(front, rows);
    scene.time.step = std::clamp(scene.time.step, scene.time.end / most, scene.time.end / fewest);
    end_with_a_step(scene.time);
}

/// By quantity and relative difference.
std::pair<std::string, double> difference(const Answer& found, const Answer& right) {
    if (!found.burns) return {"end of the burn", 1.0};
    constexpr double alight = 1.0 * um;
    if (right.burnt < alight)
        return {"largest temperature",
                std::abs(found.largest_temperature / right.largest_temperature - 1.0)};
    const double depth = std::abs(found.burnt / right.burnt - 1.0);
    const double rate = std::abs(found.rate / right.rate - 1.0);
    return depth > rate ? std::pair("burnt depth", depth) : std::pair("regression rate", rate);
}

/// At least twice the columns and rows at half the step: heats of ten times the paper's burn ten times
/// as fast.
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

}  // namespace

Answer burn_in_any_case(const Scene& scene) {
    Answer answer;
    const auto add = [&](const std::string& words) {
        answer.said += (answer.said.empty() ? "" : "; ") + words;
    };
    const auto say = [&](const Guards& guards) {
        for (const Guard& guard : guards)
            if (answer.said.find(guard.name) == std::string::npos) add(guard.name);
    };
    const Guards before = predicted(scene);
    say(remarks(before));
    try {
        refuse(before);
    } catch (const InputError& refusal) {
        answer.refused = true;
        add(refusal.what());
    }
    Simulation simulation(scene);
    Watch watch(simulation);
    const Observer listen = [&](const Simulation& now, double) {
        say(watch.record(now, now.summary()));
    };
    try {
        run_to_end(simulation, {listen});
    } catch (const NumericalFailure& failure) {
        add(failure.what());
        return answer;
    }
    answer.burns = true;
    answer.burnt = -mean_height(simulation.grid(), simulation.state().surface);
    const Summary summary = simulation.summary();
    answer.rate = summary.regression_rate;
    answer.largest_temperature = summary.largest_temperature;
    return answer;
}

Scene finest(const Scene& scene) {
    Scene fine = finer(scene);
    fine.time = {.end = reached(scene.time)};
    fine.numerics.element = Element::bbar;
    deepen(fine);
    constexpr int many_rows = 400;
    fine.domain.ny =
        std::clamp(fine.domain.ny, 2 * scene.domain.ny, std::max(many_rows, 2 * scene.domain.ny));
    refine_rows(fine);
    choose_step(fine);
    if (fine.physics.mechanics && is_refused(fine)) fine.numerics.coupling = Coupling::lagged;
    return fine;
}

Judged judge(const Scene& scene) {
    Judged judged{.found = burn_in_any_case(scene)};
    const Answer truth = burn_in_any_case(finest(scene));
    judged.can_be_judged = truth.burns;
    if (!truth.burns) return judged;
    std::tie(judged.quantity, judged.error) = difference(judged.found, truth);
    if (!judged.found.refused && judged.found.burns) return judged;
    if (auto better = advised(scene, judged.found.said)) {
        better->time.end = reached(scene.time);
        end_with_a_step(better->time);
        const Answer helped = burn_in_any_case(*better);
        judged.misled = helped.refused || difference(helped, truth).second > wrong;
    }
    return judged;
}

}  // namespace crawford
