#include "reference/slab.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "reference/slab_shooting.hpp"
#include "reference/slab_small_strain.hpp"

namespace crawford::reference {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::array models = {SlabModel::thermal, SlabModel::kuznetsov_stewart,
                               SlabModel::eulerian, SlabModel::mass_conserving};
constexpr std::array readings = {ThermalStress::alpha_k, ThermalStress::three_alpha_k};
constexpr std::array capacities = {HeatCapacity::constant_pressure, HeatCapacity::constant_volume};

/// The paper's one-dimensional study: 0.45 cm/s, 2 MPa, no heat of reaction; Q in cal/(s cm^2).
SlabConditions study(const Material& material, double flux) {
    return {.material = without_reaction(material),
            .heat_flux = flux * calorie_per_second_per_cm2,
            .burn_rate = 0.0045,
            .pressure = 2e6,
            .cold_temperature = 300.0};
}

/// AP and binder, every model, both readings of beta and of c, deep and shallow, with and without
/// the burning law.
std::vector<SlabConditions> every_combination() {
    std::vector<SlabConditions> all;
    for (const Material& material : {ap(), binder()}) {
        for (const SlabModel model : models) {
            for (const ThermalStress reading : readings) {
                for (const HeatCapacity capacity : capacities) {
                    for (const double depth : {infinite, 480e-6, 60e-6}) {
                        for (const Regression regression :
                             {Regression::prescribed, Regression::pyrolysis}) {
                            SlabConditions conditions = study(material, 150.0);
                            conditions.material = material;
                            conditions.model = model;
                            conditions.thermal_stress = reading;
                            conditions.heat_capacity = capacity;
                            conditions.depth = depth;
                            conditions.regression = regression;
                            all.push_back(conditions);
                        }
                    }
                }
            }
        }
    }
    return all;
}

std::vector<double> depths(double bottom, int count) {
    std::vector<double> y;
    for (int i = 0; i < count; ++i) y.push_back(-bottom * i / (count - 1));
    return y;
}

double relative(double value, double truth) {
    return std::abs(value / truth - 1.0);
}

// Sixteen surface temperatures computed beforehand to 0.01 K with a third code (a Python
// quadrature), so the bound is their rounding.
TEST(Slab, SurfaceTemperatures) {
    struct Row {
        Material material;
        double flux;
        ThermalStress reading;
        std::array<double, 4> temperature;
    };
    const std::array rows = {
        Row{ap(), 200.0, ThermalStress::alpha_k, {1059.73, 1059.58, 1058.22, 1059.58}},
        Row{ap(), 200.0, ThermalStress::three_alpha_k, {1059.73, 1058.40, 1054.35, 1058.39}},
        Row{binder(), 100.0, ThermalStress::alpha_k, {1105.15, 1057.65, 1030.87, 1055.66}},
        Row{binder(), 100.0, ThermalStress::three_alpha_k, {1105.15, 845.45, 808.38, 831.10}}};
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < models.size(); ++i) {
            SlabConditions conditions = study(row.material, row.flux);
            conditions.thermal_stress = row.reading;
            conditions.model = models[i];
            EXPECT_NEAR(Slab(conditions).surface_temperature(), row.temperature[i], 0.0051);
        }
    }
}

// Both are converged to better than 1e-12; 1e-10 is what a truth must hold.
TEST(Slab, ClosedFormAgreesWithShooting) {
    for (const SlabConditions& conditions : every_combination()) {
        const Slab closed(conditions);
        const SlabShooting shot(conditions);
        EXPECT_LT(relative(closed.surface_temperature(), shot.surface_temperature()), 1e-10);
        EXPECT_LT(relative(closed.burn_rate(), shot.burn_rate()), 1e-10);

        const auto y = depths(std::isinf(conditions.depth) ? 5e-3 : conditions.depth, 41);
        const auto exact = closed.states(y);
        const auto other = shot.states(y);
        for (std::size_t i = 0; i < y.size(); ++i) {
            EXPECT_LT(relative(exact[i].temperature, other[i].temperature), 1e-10) << y[i];
            EXPECT_NEAR(exact[i].velocity, other[i].velocity, 1e-10 * closed.burn_rate()) << y[i];
            if (conditions.model == SlabModel::thermal) continue;
            EXPECT_LT(relative(exact[i].stress_11, other[i].stress_11), 1e-10) << y[i];
        }
    }
}

// The temperature *rise* too, where it is tiny: relative to D the two agree nearly as well, 12
// e-foldings down.
TEST(Slab, ClosedFormAgreesWithShootingInTheColdTail) {
    const SlabConditions conditions = study(ap(), 200.0);
    const std::array y = {-450e-6};
    const double rise = Slab(conditions).states(y)[0].temperature - 300.0;
    EXPECT_GT(rise, 1e-4);
    // T near 300 carries 6e-14 of rounding, 6e-10 of this rise
    EXPECT_LT(relative(SlabShooting(conditions).states(y)[0].temperature - 300.0, rise), 2e-9);
}

// The differential energy equation, differentiated here from the profile by a sixth-order stencil.
// Truncation is about (m h)^6/140 = 1e-12 where the profile is steepest, 1/m = 20 um, and rounding
// 1e-13 K/(T' h) = 1e-13.
TEST(Slab, ProfileObeysTheEnergyEquation) {
    for (const HeatCapacity capacity : capacities) {
        SlabConditions conditions = study(binder(), 100.0);
        conditions.heat_capacity = capacity;
        const Slab slab(conditions);
        const Material& m = conditions.material;
        const double beta = 3.0 * m.thermal_expansion * m.bulk_modulus;
        const double h = 0.5e-6;
        for (const double y : {-10e-6, -30e-6, -60e-6, -120e-6}) {
            std::vector<double> points;
            for (int k = -3; k <= 3; ++k) points.push_back(y + k * h);
            const auto s = slab.states(points);
            const auto first = [&](auto field) {
                return (45.0 * (s[4].*field - s[2].*field) - 9.0 * (s[5].*field - s[1].*field) +
                        (s[6].*field - s[0].*field)) /
                       (60.0 * h);
            };
            const double conduction =
                m.thermal_conductivity * first(&SlabState::temperature_gradient);
            const double slope = first(&SlabState::temperature);
            const double stretching = first(&SlabState::velocity);
            const double given_back = capacity == HeatCapacity::constant_volume
                                          ? beta * beta / m.bulk_modulus * s[3].temperature
                                          : 0.0;
            const double convection = (m.density * m.specific_heat - given_back) *
                                      (slab.burn_rate() + s[3].velocity) * slope;
            const double work = beta * s[3].temperature * stretching;
            EXPECT_NEAR(conduction, convection + work, 1e-9 * conduction);
            EXPECT_NEAR(slope, s[3].temperature_gradient, 1e-9 * slope);

            // stress: (r_b + v) sigma' = C:D - beta (r_b + v) T', for both normal components
            const double carrier = slab.burn_rate() + s[3].velocity;
            const double heating = beta * carrier * slope;
            EXPECT_NEAR(m.uniaxial_modulus() * stretching - heating, 0.0, 1e-9 * heating);
            EXPECT_NEAR(m.lame() * stretching - heating, carrier * first(&SlabState::stress_11),
                        1e-9 * heating);
        }
    }
}

// A solid that expands as if nothing confined it takes c_p, whatever it is made of: with the
// capacity at constant volume, mass conserved and no shear modulus to resist, stress work leaves no
// trace in the temperature. With binder's own shear modulus what is left is 4 mu/(3 K) = 3e-4 of
// its stress work, some 1e-4 of its heat.
TEST(Slab, FreeExpansionTakesTheHeatCapacityAtConstantPressure) {
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

// Beyond largest_rise() more heat would make it colder.
TEST(Slab, RefusesMoreHeatThanTheSolidCanTake) {
    SlabConditions conditions = study(ap(), 200.0);
    conditions.heat_capacity = HeatCapacity::constant_volume;
    conditions.model = SlabModel::kuznetsov_stewart;
    conditions.material.thermal_expansion = 1e-4;
    EXPECT_LT(Slab(conditions).surface_temperature(), 2000.0);
    conditions.heat_flux *= 2.0;
    try {
        Slab slab(conditions);
        FAIL() << slab.surface_temperature();
    } catch (const std::invalid_argument& error) {
        EXPECT_EQ(
            std::string(error.what()),
            "heat_flux is too large: the solid is out of heat capacity before it conducts it");
    }
}

TEST(Slab, ThermalModelIsTheExponential) {
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
TEST(Slab, KuznetsovStewartIsTheSmallStrainLimit) {
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
TEST(Slab, SensitivityToSmallStrain) {
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

TEST(Slab, SensitivityRefusesWhatItWasNotDerivedFor) {
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

// Under the burning law rate and temperature follow from one another, and all heat that enters
// leaves as hot solid: the enthalpy balance of the thermal model is exact in elementary terms.
TEST(Slab, BurningLawIsConsistent) {
    SlabConditions conditions = study(ap(), 200.0);
    conditions.material = ap();
    conditions.regression = Regression::pyrolysis;
    conditions.burn_rate = missing;
    for (const SlabModel model : models) {
        conditions.model = model;
        const Slab slab(conditions);
        EXPECT_LT(
            relative(slab.burn_rate(), 1450.0 * std::exp(-11000.0 / slab.surface_temperature())),
            1e-13);
        const double entering = conditions.heat_flux - 47.0 * 4184.0 * 1950.0 * slab.burn_rate();
        EXPECT_LT(relative(0.405 * slab.state(0.0).temperature_gradient, entering), 1e-12);
        if (model == SlabModel::thermal) {
            const double carried =
                1950.0 * slab.burn_rate() * 1255.2 * (slab.surface_temperature() - 300.0);
            EXPECT_LT(relative(carried, entering), 1e-12);
        }
    }
}

TEST(Slab, StressAndDeformationOfTheLimits) {
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

TEST(Slab, BottomOfALayerIsCold) {
    for (const SlabConditions& conditions : every_combination()) {
        if (std::isinf(conditions.depth)) continue;
        const SlabState bottom = Slab(conditions).state(-conditions.depth);
        EXPECT_NEAR(bottom.temperature, 300.0, 1e-9);
        EXPECT_GT(bottom.temperature_gradient, 0.0);
    }
}

TEST(Slab, VeryDeepLayerIsAHalfSpace) {
    SlabConditions conditions = study(binder(), 100.0);
    const double half_space = Slab(conditions).surface_temperature();
    conditions.depth = 1.0;
    EXPECT_DOUBLE_EQ(Slab(conditions).surface_temperature(), half_space);
}

std::string complaint(const SlabConditions& conditions) {
    try {
        Slab slab(conditions);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(Slab, RefusesWhatIsMissingOrOutOfRangeByName) {
    const SlabConditions good = study(ap(), 200.0);
    EXPECT_EQ(complaint(good), "");
    auto bad = good;
    bad.heat_flux = missing;
    EXPECT_EQ(complaint(bad), "heat_flux is missing");
    bad = good;
    bad.burn_rate = -1.0;
    EXPECT_EQ(complaint(bad), "burn_rate = -1 must be positive");
    bad = good;
    bad.material.density = missing;
    EXPECT_EQ(complaint(bad), "density is missing");
    bad = good;
    bad.depth = 0.0;
    EXPECT_EQ(complaint(bad), "depth = 0 must be positive");
    bad = good;
    bad.material.heat_of_reaction = -1e9;
    EXPECT_EQ(complaint(bad), "heat_flux is too small: the heat of reaction takes all of it");
    EXPECT_THROW(Slab(good).temperature(1e-9), std::invalid_argument);
    EXPECT_THROW(Slab(good).temperature(missing), std::invalid_argument);
}

}  // namespace
}  // namespace crawford::reference
