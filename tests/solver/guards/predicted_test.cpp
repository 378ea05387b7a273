// What a scene is told before it is run, and that what it is told is so.
#include "solver/guards/predicted.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "solver/guards/burning_guards.hpp"
#include "solver/guards/steady_slab.hpp"
#include "solver/run/loop.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

using ::testing::HasSubstr;

Scene burning_slab(double flux, int ny = 96) {
    Scene scene;
    scene.domain = {.width = 5e-6, .depth = 480e-6, .nx = 1, .ny = ny, .clustering = 2.0};
    scene.physics = {.heat = true, .mechanics = false, .reference_map = false};
    scene.surface = {.pressure = 2e6, .heat_flux = {flux}};
    scene.time = {.step = 20e-6, .end = 0.2};
    return scene;
}

const Guard& named(const Guards& guards, const std::string& name) {
    const auto found = std::ranges::find(guards, name, &Guard::name);
    if (found == guards.end()) throw std::logic_error("no guard " + name);
    return *found;
}

std::string refusal(const Scene& scene) {
    try {
        refuse(predicted(scene));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Predicted, SlabBurnsAsTheSolverDoes) {
    const Scene scene = burning_slab(8.368e6);
    const SteadySlab slab = steady_slab(scene, 0).slab;
    Simulation simulation(scene);
    run_steps(simulation, 4000);
    EXPECT_NEAR(slab.burn_rate / simulation.summary().mean_burn_rate, 1.0, 1e-3);
    EXPECT_NEAR(slab.surface_temperature, simulation.summary().largest_temperature, 0.2);
}

double burnt(const Scene& scene) {
    Simulation simulation(scene);
    run_to_end(simulation);
    return -simulation.state().surface[0];
}

TEST(Predicted, AShortBurnInFewStepsIsSpokenOf) {
    Scene scene = burning_slab(8.368e6);
    scene.time = {.step = 80e-6, .end = 4.96e-3};
    Scene fine = scene;
    fine.domain.ny = 192;
    fine.time.step = 5e-6;
    EXPECT_GT(std::abs(burnt(scene) / burnt(fine) - 1.0), 0.02);
    const Guard ignition = named(predicted(scene), "ignition");
    EXPECT_EQ(ignition.beyond, Beyond::remark);
    EXPECT_THAT(ignition.text, HasSubstr("reduce time.step to"));
    Scene advised = scene;
    advised.time.step = 0.99 * ignition.longest_step.value();
    EXPECT_EQ(named(predicted(advised), "ignition").beyond, Beyond::nothing);

    scene.time.end = fine.time.end = 40e-3;
    EXPECT_LT(std::abs(burnt(scene) / burnt(fine) - 1.0), 0.005);
    EXPECT_EQ(named(predicted(scene), "ignition").beyond, Beyond::nothing);
}

TEST(Predicted, AShortBurnInHighRowsIsSpokenOf) {
    Scene scene = burning_slab(8.368e6, 24);
    scene.domain.clustering = 0.0;
    scene.time.end = 8e-3;
    Scene fine = scene;
    fine.domain.ny = 192;
    EXPECT_GT(std::abs(burnt(scene) / burnt(fine) - 1.0), 0.02);
    EXPECT_EQ(named(predicted(scene), "ignition").beyond, Beyond::remark);
}

TEST(Predicted, AStripOfOneColumnIsSpokenOf) {
    Scene scene = burning_slab(8.368e6, 48);
    scene.domain.width = 240e-6;
    scene.domain.nx = 48;
    scene.domain.half = true;
    scene.morphology = {.shape = Sandwich{5e-6},
                        .materials = {ammonium_perchlorate(), htpb_binder()}};
    scene.surface.heat_flux = {8.368e6, 0.8 * 8.368e6};
    EXPECT_EQ(named(predicted(scene), "columns_in_layer").beyond, Beyond::nothing)
        << "V moves by 0.15 % with twice the columns";
    scene.morphology.materials[1].pyrolysis_prefactor *= 30.0;  // the strip leads
    const Guard one = named(predicted(scene), "columns_in_layer");
    EXPECT_EQ(one.beyond, Beyond::remark);
    EXPECT_THAT(one.text, HasSubstr("domain.nx to 144 or more"));
    scene.domain.nx = 144;
    EXPECT_EQ(named(predicted(scene), "columns_in_layer").beyond, Beyond::nothing);
}

TEST(Predicted, HeatThatStaysInAColumnIsSpokenOf) {
    Scene scene = testing::sandwich(24, 24);
    EXPECT_EQ(named(predicted(scene), "column_peclet").beyond, Beyond::nothing);
    scene.morphology.materials[1].bulk_modulus *= 1000.0;
    EXPECT_EQ(named(predicted(scene), "column_peclet").beyond, Beyond::remark);
}

TEST(Predicted, CoupledSlabBurnsAsTheSolverDoes) {
    Scene scene = testing::slab(htpb_binder(), 192);
    scene.domain.clustering = 2.0;
    scene.time = {.step = 40e-6, .end = 0.3};
    Simulation simulation(scene);
    run_steps(simulation, 6000);
    EXPECT_NEAR(steady_slab(scene, 0).slab.surface_temperature,
                simulation.summary().largest_temperature, 0.5);
}

TEST(Predicted, OnsetOfAnExothermicFrontIsRemarkedAndNeverRefused) {
    Scene scene = burning_slab(8.368e6);
    for (const double q : {0.44e6, 0.456e6, 0.458e6, 0.8e6, 2e6}) {
        scene.morphology.materials[0].heat_of_reaction = q;
        const Guards guards = predicted(scene);
        EXPECT_EQ(named(guards, "onset").beyond == Beyond::remark, q > 0.457e6) << q;
        EXPECT_EQ(refusal(scene), "") << q;
    }
}

TEST(Predicted, ASceneWithoutABurningSolutionIsRefusedWithTheReason) {
    Scene cold = burning_slab(8.368e6);
    cold.morphology.materials[0].activation_temperature = 3000.0;
    EXPECT_THAT(refusal(cold), HasSubstr("its surface would be colder"));
    EXPECT_NEAR(named(predicted(cold), "surface_temperature").value, 275.0, 1.0);
    Scene slow = burning_slab(8.368e6);
    slow.physics.regression = Regression::fixed;
    slow.surface.burn_rate = 1e-9;
    EXPECT_THAT(refusal(slow), HasSubstr("would have to be this hot"));
    // Q/(rho c r_b), rigid: what flows in is carried off.
    const Material& ap = slow.morphology.materials[0];
    const double carried = 300.0 + (8.368e6 / 1e-9 + ap.heat_of_reaction * ap.density) /
                                       (ap.density * ap.specific_heat);
    EXPECT_NEAR(named(predicted(slow), "surface_temperature").value / carried, 1.0, 1e-6);
}

TEST(Predicted, AFrontThatAlternatesIsRefusedAndItsAdviceHelps) {
    Scene scene = burning_slab(8.368e7);
    scene.time.step = 40e-6;
    EXPECT_THAT(refusal(scene), HasSubstr("front_coupling = 2.6"));
    EXPECT_THAT(refusal(scene), HasSubstr("reduce time.step to 7.6 us"));
    scene.time.step = 7.6e-6;
    EXPECT_TRUE(remarks(predicted(scene)).empty());
}

/// Part of the burn rate by which the last two steps of many differ, at this part of the limit.
double last_change(Scene scene, double part) {
    const Grid grid(scene.domain);
    const Material& material = scene.morphology.materials[0];
    const SteadySlab slab = steady_slab(scene, 0).slab;
    for (int k = 0; k < 30; ++k)  // the limit hangs on the step
        scene.time.step *= part * front_limit(scene, grid, material, slab) /
                           front_coupling(scene, grid, material, slab).value;
    Simulation simulation(scene);
    run_steps(simulation, 400);
    const double before = simulation.summary().mean_burn_rate;
    run_steps(simulation, 1);
    return std::abs(simulation.summary().mean_burn_rate / before - 1.0);
}

TEST(Predicted, LimitOfTheFrontIsWhereTheSolverBeginsToAlternate) {
    // Fine rows, so that the limit is that of the equation.
    for (const Stepping scheme : {Stepping::euler, Stepping::bdf2}) {
        Scene scene = burning_slab(8.368e6, 384);
        scene.time.scheme = scheme;
        EXPECT_LT(last_change(scene, 0.9), 1e-6);
        EXPECT_GT(last_change(scene, 1.1), 1e-2);
    }
}

TEST(Predicted, AWindowTooShallowIsRemarkedWithADepthThatIsNot) {
    Scene scene = burning_slab(8.368e6);
    scene.domain.depth = 50e-6;
    const Guard shallow = named(predicted(scene), "layers_in_window");
    EXPECT_EQ(shallow.beyond, Beyond::remark);
    EXPECT_THAT(shallow.text, HasSubstr("raise domain.depth to "));
    const double micrometres = std::stod(shallow.text.substr(shallow.text.find(" to ") + 4));
    scene.domain.depth = 1e-6 * micrometres;
    EXPECT_EQ(named(predicted(scene), "layers_in_window").beyond, Beyond::nothing);
}

TEST(Predicted, RowsTooHighAreRemarked) {
    const Guards coarse = predicted(burning_slab(8.368e6, 4));
    EXPECT_EQ(named(coarse, "cell_peclet").beyond, Beyond::remark);
    EXPECT_TRUE(remarks(predicted(burning_slab(8.368e6, 32))).empty());
}

TEST(Predicted, ASandwichLikeTheShippedOneGetsNoRemark) {
    Scene scene = testing::sandwich(64, 96);
    for (const double step : {20e-6, 40e-6, 80e-6, 160e-6, 240e-6}) {
        scene.time.step = step;
        EXPECT_TRUE(remarks(predicted(scene)).empty()) << step;
        EXPECT_EQ(refusal(scene), "") << step;
    }
}

}  // namespace
}  // namespace crawford
