/// The slab where it tends to something simpler: no coupling, small strain, free expansion, great depth.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "reference/slab_small_strain.hpp"
#include "tests/reference/slab_study.hpp"

namespace crawford::reference {
namespace {

// A solid that expands as if nothing confined it takes c_p, whatever it is made of: with the
// capacity at constant volume, mass conserved and no shear modulus to resist, stress work leaves no
// trace in the temperature. With binder's own shear modulus what is left is 4 mu/(3 K) = 3e-4 of
// its stress work, some 1e-4 of its heat.
TEST(SlabLimits, FreeExpansionTakesTheHeatCapacityAtConstantPressure) {
    for (const ThermalStress reading : readings) {
        for (const SlabModel model : {SlabModel::kuznetsov_stewart, SlabModel::mass_conserving}) {
            SlabConditions conditions = study(binder(), 100.0);
            conditions.thermal_stress = reading;
            conditions.heat_capacity = HeatCapacity::constant_volume;
            conditions.model = SlabModel::thermal;
            const double rigid = Slab(conditions).surface_temperature();
            conditions.model = model;
            EXPECT_NEAR(Slab(conditions).surface_temperature(), rigid, 0.3);
            EXPECT_GT(Slab(conditions).surface_temperature(), rigid);
            conditions.material.shear_modulus = 1e-3;
            EXPECT_NEAR(Slab(conditions).surface_temperature(), rigid, 1e-9);
        }
    }
}

TEST(SlabLimits, ThermalModelIsTheExponential) {
    SlabConditions conditions = study(ap(), 200.0);
    conditions.model = SlabModel::thermal;
    const Slab slab(conditions);
    const Material& m = conditions.material;
    const double growth = m.density * m.specific_heat * 0.0045 / m.thermal_conductivity;
    const double rise = conditions.heat_flux / (m.density * m.specific_heat * 0.0045);
    for (const double y : depths(480e-6, 13)) {
        EXPECT_NEAR(slab.temperature(y), 300.0 + rise * std::exp(growth * y), 1e-9);
    }
    conditions.depth = 100e-6;
    const Slab thin(conditions);
    for (const double y : depths(100e-6, 13)) {
        const double exact = rise * (std::exp(growth * y) - std::exp(-growth * 100e-6));
        EXPECT_NEAR(thin.temperature(y), 300.0 + exact, 1e-9);
    }
}

// Kuznetsov-Stewart is the limit of small strain at fixed coupling: K and mu times N^2, alpha over
// N. What is left of the difference is proportional to theta, that is to 1/N, with relative
// corrections of the same order.
TEST(SlabLimits, KuznetsovStewartIsTheSmallStrainLimit) {
    const auto difference = [](double n, SlabModel model) {
        SlabConditions conditions = study(binder(), 100.0);
        conditions.material.bulk_modulus *= n * n;
        conditions.material.shear_modulus *= n * n;
        conditions.material.thermal_expansion /= n;
        conditions.model = model;
        const double finite = Slab(conditions).surface_temperature();
        conditions.model = SlabModel::kuznetsov_stewart;
        return Slab(conditions).surface_temperature() - finite;
    };
    for (const SlabModel model : {SlabModel::eulerian, SlabModel::mass_conserving}) {
        for (const double n : {64.0, 256.0}) {
            EXPECT_NEAR(difference(n, model) / difference(2.0 * n, model), 2.0, 1.0 / n);
        }
    }
}

// The slope of that limit by perturbation, against divided differences of the closed forms,
// extrapolated twice. 1/N = 1/512 leaves (theta D/N)^3 = 1e-10, and rounding of T_s 1e-13 N.
TEST(SlabLimits, SensitivityToSmallStrain) {
    for (const auto& [material, capacity] :
         {std::pair{ap(), capacities[0]}, std::pair{binder(), capacities[0]},
          std::pair{ap(), capacities[1]}, std::pair{binder(), capacities[1]}}) {
        SlabConditions conditions = study(material, 100.0);
        conditions.heat_capacity = capacity;
        const double small_strain = [&] {
            SlabConditions small = conditions;
            small.model = SlabModel::kuznetsov_stewart;
            return Slab(small).surface_temperature();
        }();
        const auto divided = [&](double n) {
            SlabConditions stiff = conditions;
            stiff.material.bulk_modulus *= n * n;
            stiff.material.shear_modulus *= n * n;
            stiff.material.thermal_expansion /= n;
            const double theta = thermal_stress_modulus(stiff) / stiff.material.uniaxial_modulus();
            return (Slab(stiff).surface_temperature() - small_strain) / theta;
        };
        const double coarse = divided(128.0);
        const double middle = divided(256.0);
        const double fine = divided(512.0);
        const double limit = (8.0 * fine - 6.0 * middle + coarse) / 3.0;
        EXPECT_LT(relative(small_strain_sensitivity(conditions), limit), 1e-7);
    }
}

TEST(SlabLimits, SensitivityRefusesWhatItWasNotDerivedFor) {
    SlabConditions conditions = study(ap(), 200.0);
    conditions.depth = 480e-6;
    EXPECT_THROW(small_strain_sensitivity(conditions), std::invalid_argument);
    conditions = study(ap(), 200.0);
    conditions.regression = Regression::pyrolysis;
    EXPECT_THROW(small_strain_sensitivity(conditions), std::invalid_argument);
    conditions = study(ap(), 200.0);
    conditions.heat_flux = missing;
    EXPECT_THROW(small_strain_sensitivity(conditions), std::invalid_argument);
}

TEST(SlabLimits, StressAndDeformationOfTheLimits) {
    SlabConditions conditions = study(ap(), 200.0);
    const Material& m = conditions.material;
    const Slab slab(conditions);
    const SlabState cold = slab.state(-1.0);
    EXPECT_NEAR(cold.temperature, 300.0, 1e-12);
    EXPECT_NEAR(cold.velocity, 0.0, 1e-18);
    EXPECT_NEAR(cold.stress_11, -m.lame() / m.uniaxial_modulus() * 2e6, 1e-6);
    EXPECT_DOUBLE_EQ(cold.deformation_gradient_22, 1.0);

    // mass conserving: the solid that comes up thins out as it stretches, F22 = (r_b + v)/r_b
    const SlabState hot = slab.state(0.0);
    EXPECT_LT(relative(hot.deformation_gradient_22, 1.0 + hot.velocity / 0.0045), 1e-14);
    EXPECT_DOUBLE_EQ(hot.stress_22, -2e6);
    EXPECT_DOUBLE_EQ(hot.pressure, -(2.0 * hot.stress_11 - 2e6) / 3.0);

    // Kuznetsov-Stewart keeps sigma_22 = P (F22 - 1) - beta D = -p_c, paper eq. 53
    conditions.model = SlabModel::kuznetsov_stewart;
    const SlabState small = Slab(conditions).state(-20e-6);
    const double beta = 3.0 * m.thermal_expansion * m.bulk_modulus;
    const double rise = small.temperature - 300.0;
    EXPECT_NEAR(m.uniaxial_modulus() * (small.deformation_gradient_22 - 1.0) - beta * rise, -2e6,
                1.0);
    EXPECT_NEAR(m.lame() * (small.deformation_gradient_22 - 1.0) - beta * rise, small.stress_11,
                1.0);
}

TEST(SlabLimits, VeryDeepLayerIsAHalfSpace) {
    SlabConditions conditions = study(binder(), 100.0);
    const double half_space = Slab(conditions).surface_temperature();
    conditions.depth = 1.0;
    EXPECT_DOUBLE_EQ(Slab(conditions).surface_temperature(), half_space);
}

}  // namespace
}  // namespace crawford::reference
