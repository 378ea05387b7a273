#include "reference/adiabatic_column.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "reference/root.hpp"

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

/// A solid by its free energy per volume under the strain e of one direction,
///
///     psi = M e^2/2 - beta e (T - T0) - rho integral of c_v (T/T' - 1) dT',   rho c_v = c - s T,
///
/// from which stress d(psi)/de and entropy -d(psi)/dT follow by complex steps.
struct Potential {
    double modulus, beta, capacity, slope, cold = 300.0;

    template <class Number>
    Number operator()(Number e, Number t) const {
        const Number rise = t - cold;
        // the integral of (c - s T')(T/T' - 1) from T0 to T
        const Number heat = capacity * (t * log(t / cold) - rise) -
                            slope * (t * rise - (t * t - cold * cold) / 2.0);
        return modulus * e * e / 2.0 - beta * e * rise - heat;
    }
    double stress(double e, double t) const {
        return (*this)(std::complex<double>(e, 1e-30), std::complex<double>(t)).imag() / 1e-30;
    }
    double entropy(double e, double t) const {
        return -(*this)(std::complex<double>(e), std::complex<double>(t, 1e-20)).imag() / 1e-20;
    }
    /// The integral of T d(entropy) on the way from T0 to T that is free of stress.
    double heat_taken(double t) const {
        const auto entropy_at = [&](double warm) {
            const double e =
                bracketed_root([&](double trial) { return stress(trial, warm); }, -1.0, 1.0);
            return entropy(e, warm);
        };
        // by parts, for nothing but the entropy itself to be found
        return t * entropy_at(t) -
               boost::math::quadrature::gauss<double, 30>::integrate(entropy_at, cold, t);
    }
};

// Where stress and entropy come from one potential, beta in the stress is beta in its work, and the
// heat that a solid takes on a path follows without any heat equation. Free to expand on all sides
// (M = K) it takes rho c_p (T - T0), if the capacity in the potential is that at constant volume;
// if c_p is put there, the solid takes beta^2/(2K) (T^2 - T0^2) more: expansion counted twice. A
// column that cannot widen (M = P) takes K/P of that.
TEST(AdiabaticColumn, FollowsFromAFreeEnergy) {
    const ConfinedSolid ap{.capacity = 1950.0 * 1255.2,
                           .stress_work = 448500.0,
                           .thermal_stress = 448500.0,
                           .lame = 14950e6 - 2.0 / 3.0 * 12500e6,
                           .shear_modulus = 12500e6,
                           .cold_temperature = 300.0};
    const double bulk = 14950e6;
    const double slope = 448500.0 * 448500.0 / bulk;
    const double confined = bulk + 4.0 / 3.0 * 12500e6;
    const double hot = 900.0;
    const double at_constant_pressure = ap.capacity * (hot - 300.0);
    const double expansion = slope * (hot * hot - 300.0 * 300.0) / 2.0;
    const auto taken = [&](double modulus, double given_back) {
        return Potential{modulus, ap.stress_work, ap.capacity, given_back}.heat_taken(hot);
    };
    const double tolerance = 1e-9 * at_constant_pressure;
    EXPECT_NEAR(taken(bulk, slope), at_constant_pressure, tolerance);
    EXPECT_NEAR(taken(bulk, 0.0), at_constant_pressure + expansion, tolerance);
    const double share = bulk / confined;
    EXPECT_NEAR(share, 0.473, 5e-4);
    EXPECT_NEAR(taken(confined, slope), at_constant_pressure - (1.0 - share) * expansion,
                tolerance);
    for (const double given_back : {0.0, slope}) {
        ConfinedSolid solid = ap;
        solid.capacity_slope = given_back;
        EXPECT_NEAR(AdiabaticColumn(solid).heated(taken(confined, given_back)), hot, 1e-6);
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
