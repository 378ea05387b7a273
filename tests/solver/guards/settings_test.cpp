// No answer is wrong without a word, and none that is sound is refused: slabs over many settings,
// against twice the rows at half the step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "solver/guards/predicted.hpp"
#include "solver/guards/watch.hpp"
#include "solver/run/loop.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

constexpr double wrong = 0.02;

Scene burning(Material material, double flux, double step, int ny, double depth) {
    Scene scene;
    scene.domain = {.width = 5e-6, .depth = depth, .nx = 1, .ny = ny, .clustering = 2.0};
    scene.morphology.materials = {std::move(material)};
    scene.physics = {.heat = true, .mechanics = false, .reference_map = false};
    scene.surface = {.pressure = 2e6, .heat_flux = {flux}};
    scene.time = {.step = step, .end = 0.04};
    return scene;
}

/// What a strand burner would tell.
struct Answer {
    double burnt = 0.0;  ///< [m]
    double rate = 0.0;   ///< burn rate at the end [m/s]
    std::string said;    ///< names of what was remarked, words of what was refused
    bool refused = false;
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
    } catch (const InputError& error) {
        answer.refused = true;
        answer.said += error.what();
    }
    Simulation simulation(scene);
    Watch watch(simulation);
    try {
        run_to_end(simulation, {[&](Simulation& s, double) { say(watch.record(s, s.summary())); }});
    } catch (const NumericalFailure& failure) {
        answer.said += failure.what();
        return answer;  // nothing burnt: as wrong as can be
    }
    answer.burnt = -simulation.state().surface[0];
    answer.rate = simulation.summary().regression_rate;
    return answer;
}

/// At least twice the rows at half the step, and more where that is too coarse itself.
Answer truth(Scene scene) {
    // Heats of ten times the paper's burn ten times as fast.
    const double step = scene.surface.heat_flux[0] > 2e7 ? 5e-6 : 20e-6;
    scene.domain.ny = std::max(2 * scene.domain.ny, 96);
    const double steps = std::max(2.0, std::ceil(scene.time.step / step));
    scene.time.step /= steps;
    if (scene.domain.depth < 400e-6) {
        scene.domain.ny = int(std::ceil(scene.domain.ny * 400e-6 / scene.domain.depth));
        scene.domain.depth = 400e-6;
    }
    return burn(scene);
}

double off(const Answer& found, const Answer& right) {
    return std::max(std::abs(found.burnt / right.burnt - 1.0),
                    std::abs(found.rate / right.rate - 1.0));
}

/// Takes what is said at its word: "reduce time.step to 7.6 us or less".
Scene advised(Scene scene, const std::string& said) {
    const std::string advice = "reduce time.step to ";
    const size_t at = said.rfind(advice);
    if (at != std::string::npos)
        scene.time.step = 1e-6 * std::stod(said.substr(at + advice.size()));
    return scene;
}

void judge(const Scene& scene, const std::string& setting) {
    const Answer found = burn(scene);
    const Answer right = truth(scene);
    ASSERT_FALSE(right.refused) << setting << ": " << right.said;
    if (right.burnt < 1e-6) return;  // not yet alight
    if (off(found, right) > wrong) {
        EXPECT_NE(found.said, "") << setting << " is off by " << off(found, right);
    }
    if (found.refused) {
        EXPECT_GT(off(found, right), wrong) << setting << " is refused: " << found.said;
        const Answer helped = burn(advised(scene, found.said));
        EXPECT_FALSE(helped.refused) << setting << ": " << helped.said;
        EXPECT_LT(off(helped, right), wrong) << setting << ": " << found.said;
    }
}

TEST(Settings, OfSlabsAreNeverWrongWithoutAWord) {
    for (const Material& material : {ammonium_perchlorate(), htpb_binder()})
        for (const double flux : {0.3, 0.5, 1.0, 2.0, 5.0, 10.0})
            for (const double step : {20e-6, 80e-6, 320e-6, 1e-3})
                judge(burning(material, flux * 8.368e6, step, 96, 480e-6),
                      material.name + " flux x" + std::to_string(flux) + " step " +
                          std::to_string(1e6 * step));
}

TEST(Settings, OfWindowsAreNeverWrongWithoutAWord) {
    for (const Material& material : {ammonium_perchlorate(), htpb_binder()})
        for (const double depth : {50e-6, 100e-6, 200e-6, 480e-6, 2000e-6})
            for (const int ny : {4, 8, 16, 48})
                judge(burning(material, 8.368e6, 40e-6, ny, depth),
                      material.name + " depth " + std::to_string(1e6 * depth) + " ny " +
                          std::to_string(ny));
}

}  // namespace
}  // namespace crawford
