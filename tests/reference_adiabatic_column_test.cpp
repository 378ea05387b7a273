#include <gtest/gtest.h>

#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <stdexcept>

#include "reference/adiabatic_column.hpp"

namespace crawford::reference {
namespace {

ConfinedSolid solid() {
    return {.capacity = 1.2e6,
            .capacity_slope = 700.0,
            .stress_work = 3e6,
            .thermal_stress = 2e6,
            .lame = 9e9,
            .shear_modulus = 1e9,
            .cold_temperature = 300.0};
}

/// T, sigma_11 and sigma_22 from the rates themselves, with `heat` and `pressure` brought evenly in
/// a unit of time.
std::array<double, 3> integrated(const ConfinedSolid& s, double heat, double pressure) {
    using State = std::array<double, 3>;
    const double modulus = s.lame + 2.0 * s.shear_modulus;
    State state{s.cold_temperature, 0.0, 0.0};
    const auto rates = [&](const State& at, State& rate, double) {
        // Two equations for dT/dt and e, as they stand.
        const double capacity = s.capacity - s.capacity_slope * at[0];
        const double work = s.stress_work * at[0];
        const double determinant = capacity * modulus + work * s.thermal_stress;
        const double heating = (heat * modulus + work * pressure) / determinant;
        const double expansion = (heat * s.thermal_stress - capacity * pressure) / determinant;
        rate = {heating, s.lame * expansion - s.thermal_stress * heating,
                modulus * expansion - s.thermal_stress * heating};
    };
    namespace odeint = boost::numeric::odeint;
    odeint::integrate_adaptive(
        odeint::make_controlled<odeint::runge_kutta_dopri5<State>>(1e-12, 1e-12), rates, state, 0.0,
        1.0, 1e-3);
    return state;
}

TEST(AdiabaticColumn, IsTheIntegralOfTheRates) {
    for (const double slope : {0.0, 700.0}) {
        ConfinedSolid s = solid();
        s.capacity_slope = slope;
        const AdiabaticColumn column(s);
        const auto heated = integrated(s, 2e8, 0.0);
        EXPECT_NEAR(column.heated(2e8), heated[0], 1e-8);
        EXPECT_NEAR(column.lateral_stress(heated[0], 0.0), heated[1], 1e-2);
        EXPECT_NEAR(heated[2], 0.0, 1e-2);
        const auto pressed = integrated(s, 0.0, 3e8);
        EXPECT_NEAR(column.pressed(3e8), pressed[0], 1e-8);
        EXPECT_NEAR(column.lateral_stress(pressed[0], 3e8), pressed[1], 1e-2);
        EXPECT_NEAR(pressed[2], -3e8, 1e-2);
    }
}

TEST(AdiabaticColumn, WithoutThermalStressHeatIsStoredAndPressureWorks) {
    ConfinedSolid s = solid();
    s.capacity_slope = s.thermal_stress = 0.0;
    const AdiabaticColumn column(s);
    EXPECT_NEAR(column.heated(1.2e8), 400.0, 1e-9);
    EXPECT_NEAR(column.pressed(1e8), 300.0 * std::exp(1e8 * 3e6 / (11e9 * 1.2e6)), 1e-9);
    EXPECT_NEAR(column.lateral_stress(300.0, 11e6), -9e6, 1e-6);
    EXPECT_EQ(column.heated(0.0), 300.0);
}

TEST(AdiabaticColumn, RefusesWhatIsMissingOrOutOfRange) {
    ConfinedSolid s = solid();
    s.lame = missing;
    EXPECT_THROW(AdiabaticColumn{s}, std::invalid_argument);
    s = solid();
    s.capacity_slope = 1000.0;
    EXPECT_THROW(AdiabaticColumn{s}, std::invalid_argument);
    EXPECT_THROW(AdiabaticColumn(solid()).heated(-1.0), std::invalid_argument);
    EXPECT_THROW(AdiabaticColumn(solid()).heated(1e10), std::invalid_argument);
}

}  // namespace
}  // namespace crawford::reference
