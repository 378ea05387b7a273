// What a run meets: the worst of each number, once, and at little cost.
#include "solver/guards/watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "base/errors.hpp"
#include "solver/run/loop.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

Scene thermal(int nx, int ny) {
    Scene scene = testing::sandwich(nx, ny);
    scene.physics.mechanics = scene.physics.reference_map = false;
    scene.time = {.step = 40e-6, .end = 0.1};
    return scene;
}

/// What is told during the steps, and what is met in the end.
struct Met {
    Guards told, worst;
    const Guard& operator[](const std::string& name) const {
        const auto found = std::ranges::find(worst, name, &Guard::name);
        if (found == worst.end()) throw std::logic_error("not met: " + name);
        return *found;
    }
};

Met run(const Scene& scene, long steps) {
    Simulation simulation(scene);
    Watch watch(simulation);
    Met met;
    run_steps(simulation, steps, {[&](Simulation& s, double) {
                  std::ranges::copy(watch.record(s, s.summary()), std::back_inserter(met.told));
              }});
    met.worst = watch.met();
    return met;
}

TEST(Watch, ASoundRunMeetsNothingBeyondALimit) {
    Scene coupled = testing::sandwich(32, 48);
    coupled.time = {.step = 40e-6, .end = 0.1};
    for (const Scene& scene : {thermal(32, 48), coupled}) {
        const Met met = run(scene, 200);
        EXPECT_TRUE(met.told.empty()) << in_words(met.told.front());
        EXPECT_GT(met["slope"].value, 0.1);
        EXPECT_GT(met["crossing_y"].value, 0.0);
        EXPECT_GT(met["relaxation"].value, 0.0);
        EXPECT_LT(met["relaxation"].value, 0.9);
    }
}

TEST(Watch, TellsASlopeThatTheGridCannotHoldOnce) {
    Scene scene = thermal(32, 48);
    scene.morphology.materials[1].pyrolysis_prefactor *= 0.01;
    const Met met = run(scene, 400);
    EXPECT_EQ(std::ranges::count(met.told, "slope", &Guard::name), 1);
    EXPECT_GT(met["slope"].value, met.told.front().value) << "the worst, not the first";
}

TEST(Watch, TellsABurnRateThatAlternates) {
    Scene scene = thermal(8, 96);
    scene.surface.heat_flux = {8.368e7, 6.6944e7};
    scene.time.step = 30e-6;  // front_coupling is 2
    const Met met = run(scene, 300);
    EXPECT_EQ(std::ranges::count(met.told, "alternation", &Guard::name), 1);
}

TEST(Watch, EndsARunWhoseCouplingTheSchemeDoesNotStand) {
    Scene scene = testing::slab(htpb_binder(), 48);
    scene.time.scheme = Stepping::bdf2;
    scene.numerics.coupling = Coupling::lagged;
    EXPECT_THROW(run(scene, 5000), NumericalFailure);
}

double seconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The least of several: the machine has other work.
double part_of_a_step(const Scene& scene) {
    Simulation simulation(scene);
    Watch watch(simulation);
    double step = 1e9, look = 1e9;
    for (int k = 0; k < 40; ++k) {
        step = std::min(step, seconds([&] { run_steps(simulation, 1); }));
        const Summary summary = simulation.summary();
        look = std::min(look, seconds([&] { watch.record(simulation, summary); }));
    }
    return look / step;
}

TEST(Watch, CostsLessThanAHundredthOfAStep) {
    Scene coupled = testing::sandwich(64, 96);
    coupled.domain.half = true;
    Scene rigid = thermal(64, 96);
    rigid.domain.half = true;
    EXPECT_LT(part_of_a_step(coupled), 0.01);
    EXPECT_LT(part_of_a_step(rigid), 0.01);
}

}  // namespace
}  // namespace crawford
