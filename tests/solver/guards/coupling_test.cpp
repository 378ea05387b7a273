// The coupling number, its limits, and what a scene beyond them is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "base/errors.hpp"
#include "solver/guards/predicted.hpp"
#include "solver/guards/steady_slab.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

using ::testing::HasSubstr;

CoupledSolid binder() {
    return coupled(htpb_binder(), {});
}

/// The larger root of what two steps make of each other with the factor -g.
double largest_root(Stepping scheme, double g) {
    if (scheme == Stepping::euler) return std::abs(g);
    return std::abs(-g - std::sqrt(std::complex<double>(g * g + g)));
}

TEST(Coupling, LimitIsWhereARootReachesOne) {
    for (const Stepping scheme : {Stepping::euler, Stepping::bdf2})
        EXPECT_NEAR(largest_root(scheme, coupling_limit(scheme)), 1.0, 1e-14);
    EXPECT_NEAR(largest_root(Stepping::bdf2, coupling_of_a_lost_step(Stepping::bdf2)), 1.1, 1e-14);
}

TEST(Coupling, OfBinderCrossesOneAt1203K) {
    EXPECT_NEAR(coupling_number(binder(), Coupling::lagged, 1203.0), 1.0, 1e-3);
    EXPECT_LT(coupling_number(binder(), Coupling::adiabatic, 1203.0), 0.0);
}

TEST(Coupling, WithUnequalBetasEulerFailsAtSEqualToRhoCAndTheOtherSchemeAtAFifth) {
    CoupledSolid solid = binder();
    solid.shear_modulus = 0.0;  // a fluid: P = K
    solid.heat_of_stretch /= 3.0;
    const double s = solid.heat_of_stretch * solid.heat_of_stretch / solid.bulk_modulus;
    const double at_rho_c = solid.heat_capacity / s;
    EXPECT_NEAR(coupling_number(solid, Coupling::adiabatic, at_rho_c), 1.0, 1e-12);
    EXPECT_NEAR(coupling_number(solid, Coupling::adiabatic, at_rho_c / 5.0), 1.0 / 3.0, 1e-12);
}

TEST(Coupling, OfTwoStepsBackAndLaggedIsRefusedInTheSandwich) {
    Scene scene = testing::sandwich(64, 96);
    refuse(predicted(scene));
    scene.numerics.coupling = Coupling::lagged;
    refuse(predicted(scene));
    scene.time.scheme = Stepping::bdf2;
    try {
        refuse(predicted(scene));
        FAIL() << "not refused";
    } catch (const InputError& error) {
        for (const char* part : {"coupling = 0.7", "limit 0.3333", "\"lagged\"", "\"bdf2\"",
                                 "binder", "take numerics.coupling = \"adiabatic\""})
            EXPECT_THAT(error.what(), HasSubstr(part));
    }
}

TEST(Coupling, AdviceHelpsWhateverTheReadings) {
    for (const ThermalStress work : {ThermalStress::three_alpha_bulk, ThermalStress::alpha_bulk}) {
        Scene scene = testing::sandwich(64, 96);
        scene.morphology.materials[1].thermal_expansion *= 4.0;
        scene.time.scheme = Stepping::bdf2;
        scene.numerics.stress_work = work;
        scene.numerics.coupling = Coupling::lagged;
        EXPECT_THROW(refuse(predicted(scene)), InputError);
        scene.numerics.coupling = Coupling::adiabatic;
        if (work == ThermalStress::alpha_bulk) {
            EXPECT_THROW(refuse(predicted(scene)), InputError);
            scene.numerics.stress_work = scene.numerics.thermal_stress;
        }
        refuse(predicted(scene));
    }
}

TEST(Coupling, LaggedWithANegativeHeatCapacityIsRefusedAndSplitIsNot) {
    Scene scene = testing::sandwich(64, 96);
    scene.morphology.materials[1].thermal_expansion *= 3.0;
    scene.numerics.heat_capacity = HeatCapacity::constant_volume;
    refuse(predicted(scene));
    scene.numerics.coupling = Coupling::lagged;
    try {
        refuse(predicted(scene));
        FAIL() << "not refused";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("heat_capacity = -"));
        EXPECT_THAT(error.what(), HasSubstr("take numerics.coupling = \"adiabatic\""));
    }
}

TEST(Coupling, VeryStrongExpansionIsRemarkedWhereTwoStepsBackDoNotHoldIt) {
    Scene scene = testing::sandwich(64, 96);
    scene.time.scheme = Stepping::bdf2;
    EXPECT_TRUE(remarks(predicted(scene)).empty());
    scene.morphology.materials[1].thermal_expansion *= 2.2;
    const Guards found = remarks(predicted(scene));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().name, "expansion");
    scene.time.scheme = Stepping::euler;
    EXPECT_TRUE(remarks(predicted(scene)).empty());
}

}  // namespace
}  // namespace crawford
