/// The slab in closed form against shooting, its equations and its boundary conditions.
#include "reference/slab.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "reference/slab_shooting.hpp"
#include "tests/reference/slab_study.hpp"

namespace crawford::reference {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

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

TEST(Slab, BottomOfALayerIsCold) {
    for (const SlabConditions& conditions : every_combination()) {
        if (std::isinf(conditions.depth)) continue;
        const SlabState bottom = Slab(conditions).state(-conditions.depth);
        EXPECT_NEAR(bottom.temperature, 300.0, 1e-9);
        EXPECT_GT(bottom.temperature_gradient, 0.0);
    }
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
