#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "reference/manufactured_heat.hpp"
#include "reference/thermal_laminate.hpp"
#include "reference/travelling_layer.hpp"

namespace crawford::reference {
namespace {

constexpr double um = 1e-6;

/// First derivative by differences of order six. On the lengths and times of these fields the
/// truncation and the round-off are below 1e-8 of the largest derivative.
template <class Function>
double slope(const Function& f, double at, double h) {
    const auto across = [&](double step) { return f(at + step) - f(at - step); };
    return (45.0 * across(h) - 9.0 * across(2.0 * h) + across(3.0 * h)) / (60.0 * h);
}

/// First derivative by the complex step, which takes no difference and so loses no digit.
template <class Function>
double complex_slope(const Function& f, double at) {
    constexpr double step = 1e-30;
    return std::imag(f(std::complex<double>(at, step))) / step;
}

HeatedSolid deforming_solid() {
    return {.conductivity = 0.3,
            .capacity = 1.2e6,
            .stress_work = 3e6,
            .capacity_slope = 900.0,
            .width = 240 * um,
            .depth = 200 * um,
            .cold_temperature = 300.0,
            .rise = 250.0,
            .frequency = 500.0,
            .surface_wave = 20 * um,
            .regression_rate = 0.0045,
            .speed = 0.002};
}

struct Place {
    double x, y, t;
};
constexpr Place places[]{{0.0, -3 * um, 0.0},
                         {31 * um, -150 * um, 2e-3},
                         {-77 * um, 10 * um, 0.7e-3},
                         {111 * um, -42 * um, 5e-3}};

/// What the manufactured fields are differentiated to, found from their values alone.
struct Derived {
    double x, y, t, laplacian, divergence;
};
Derived derived(const ManufacturedHeat& heat, const Place& p) {
    const auto in_x = [&](auto at) { return heat.temperature(at, p.y, p.t); };
    const auto in_y = [&](auto at) { return heat.temperature(p.x, at, p.t); };
    const auto in_t = [&](auto at) { return heat.temperature(p.x, p.y, at); };
    const auto u = [&](auto at) { return heat.velocity(at, p.y, p.t)[0]; };
    const auto v = [&](auto at) { return heat.velocity(p.x, at, p.t)[1]; };
    const auto of = [](const auto& f) { return [&f](double at) { return complex_slope(f, at); }; };
    return {complex_slope(in_x, p.x), complex_slope(in_y, p.y), complex_slope(in_t, p.t),
            slope(of(in_x), p.x, 1 * um) + slope(of(in_y), p.y, 1 * um),
            complex_slope(u, p.x) + complex_slope(v, p.y)};
}

TEST(ManufacturedHeat, SourceIsTheResidualOfTheHeatEquation) {
    const HeatedSolid solid = deforming_solid();
    const ManufacturedHeat heat(solid);
    for (const Place& p : places) {
        const Derived d = derived(heat, p);
        const double temperature = heat.temperature(p.x, p.y, p.t);
        const auto [u, v] = heat.velocity(p.x, p.y, p.t);
        const double rate = d.t + u * d.x + v * d.y;
        const double stored = (1.2e6 - 900.0 * temperature) * rate;
        const double worked = 3e6 * temperature * d.divergence;
        const double size = std::abs(stored) + std::abs(worked) + std::abs(0.3 * d.laplacian);
        EXPECT_NEAR(heat.source(p.x, p.y, p.t), stored - 0.3 * d.laplacian + worked, 1e-9 * size);
        EXPECT_NEAR(heat.material_rate(p.x, p.y, p.t), rate, 1e-12 * std::abs(rate));
        EXPECT_NEAR(heat.divergence(p.x, p.y, p.t), d.divergence, 1e-12 * std::abs(d.divergence));
    }
}

TEST(ManufacturedHeat, FluxIsNormalToTheSurface) {
    const ManufacturedHeat heat(deforming_solid());
    for (const Place& p : places) {
        const double y = heat.surface(p.x, p.t);
        const double angle =
            std::atan(complex_slope([&](auto at) { return heat.surface(at, p.t); }, p.x));
        const Derived d = derived(heat, {p.x, y, p.t});
        const double outward = -std::sin(angle) * d.x + std::cos(angle) * d.y;
        EXPECT_NEAR(heat.surface_flux(p.x, p.t), 0.3 * outward, 1e-12 * std::abs(outward));
        EXPECT_NEAR(heat.surface_rate(p.x, p.t),
                    complex_slope([&](auto at) { return heat.surface(p.x, at); }, p.t), 1e-15);
    }
}

TEST(ManufacturedHeat, BottomIsColdAndAtRestAndSidesArePeriodic) {
    const ManufacturedHeat heat(deforming_solid());
    for (const Place& p : places) {
        const double bottom = heat.surface(p.x, p.t) - 200 * um;
        EXPECT_NEAR(heat.temperature(p.x, bottom, p.t), 300.0, 1e-9);
        EXPECT_NEAR(heat.velocity(p.x, bottom, p.t)[1], 0.0, 1e-15);
        EXPECT_NEAR(heat.source(p.x, p.y, p.t), heat.source(p.x + 240 * um, p.y, p.t),
                    1e-9 * std::abs(heat.source(p.x, p.y, p.t)));
    }
}

// Every term must be seen: no field may happen to be constant in what it is differentiated by.
TEST(ManufacturedHeat, EveryTermIsAtWork) {
    const ManufacturedHeat heat(deforming_solid());
    for (const Place& p : places) {
        const Derived d = derived(heat, p);
        for (const double term : {d.x, d.y, d.t, d.laplacian, d.divergence})
            EXPECT_GT(std::abs(term), 1.0);
    }
}

TEST(ManufacturedHeat, LinearFieldsDoNotCurve) {
    HeatedSolid solid = deforming_solid();
    solid.linear = true;
    const ManufacturedHeat heat(solid);
    for (const Place& p : places) {
        const Derived d = derived(heat, p);
        EXPECT_EQ(d.x, 0.0);
        EXPECT_NEAR(d.laplacian, 0.0, 1e-6 * std::abs(d.y) / um);
        EXPECT_NEAR(d.divergence, heat.divergence(0.0, 0.0, p.t), 1e-12 * std::abs(d.divergence));
        EXPECT_DOUBLE_EQ(heat.surface(p.x, p.t), heat.surface(0.0, p.t));
    }
}

BurningHalfSpace half_space() {
    return {.conductivity = 0.405,
            .capacity = 1950.0 * 1255.2,
            .regression_rate = 0.0045,
            .flux = 8.368e6,
            .cold_temperature = 300.0};
}

TEST(TravellingLayer, SteadyAndHeatingObeyTheEquation) {
    const BurningHalfSpace s = half_space();
    const TravellingLayer layer(s);
    const double through_surface =
        slope([&](double at) { return layer.heating(at, 3e-3); }, 0.0, 0.2 * um);
    EXPECT_NEAR(s.conductivity * through_surface, s.flux, 1e-7 * s.flux);
    EXPECT_NEAR(s.conductivity *
                    slope([&](double at) { return layer.steady(at, 240 * um); }, 0.0, 0.2 * um),
                s.flux, 1e-7 * s.flux);
    EXPECT_NEAR(layer.steady(-240 * um, 240 * um), 300.0, 1e-9);
    for (const double eta : {-1 * um, -20 * um, -60 * um}) {
        const auto gradient = [&](double at) {
            return slope([&](double y) { return layer.heating(y, 3e-3); }, at, 0.5 * um);
        };
        const double rate = slope([&](double t) { return layer.heating(eta, t); }, 3e-3, 2e-5);
        const double conducted = s.conductivity * slope(gradient, eta, 0.5 * um);
        EXPECT_NEAR(s.capacity * (rate + s.regression_rate * gradient(eta)), conducted,
                    1e-6 * conducted);
        const auto steady = [&](double at) {
            return slope([&](double y) { return layer.steady(y, 240 * um); }, at, 0.5 * um);
        };
        EXPECT_NEAR(s.capacity * s.regression_rate * steady(eta),
                    s.conductivity * slope(steady, eta, 0.5 * um),
                    1e-6 * s.flux / layer.thickness());
    }
}

// What has entered is stored or has burnt away; the integrals are independent of the equation.
TEST(TravellingLayer, HeatingKeepsTheBalanceOfEnergy) {
    const BurningHalfSpace s = half_space();
    const TravellingLayer layer(s);
    using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
    const double end = 4e-3;
    const double stored = Quadrature::integrate(
        [&](double eta) { return layer.heating(eta, end) - 300.0; }, -400 * um, 0.0, 10, 1e-12);
    // T_s - T0 grows as the root of t at first: integrated over the root it is smooth.
    const double burnt = Quadrature::integrate(
        [&](double root) {
            return root > 0.0 ? 2.0 * root * (layer.heating(0.0, root * root) - 300.0) : 0.0;
        },
        0.0, std::sqrt(end), 10, 1e-12);
    EXPECT_NEAR(s.capacity * (stored + s.regression_rate * burnt), s.flux * end,
                1e-9 * s.flux * end);
}

TEST(TravellingLayer, HeatingBeginsAsASolidAtRestAndEndsSteady) {
    const BurningHalfSpace s = half_space();
    const TravellingLayer layer(s);
    // At rest 2 Q sqrt(D t/pi)/kappa; the motion is felt as r sqrt(t/D), 1e-4 of it here.
    const double early = 1e-11;
    const double at_rest = 2.0 * s.flux / s.conductivity *
                           std::sqrt(s.conductivity / s.capacity * early / std::numbers::pi);
    EXPECT_NEAR(layer.heating(0.0, early) - 300.0, at_rest, 1e-4 * at_rest);
    for (const double eta : {0.0, -30 * um, -100 * um})
        EXPECT_NEAR(layer.heating(eta, 1.0), layer.steady(eta, 1.0), 1e-9);
}

TwoConductors conductors() {
    return {.inner_conductivity = 0.05,
            .outer_conductivity = 0.4,
            .inner_capacity = 1e6,
            .outer_capacity = 2.5e6,
            .strip = 60 * um,
            .width = 240 * um,
            .depth = 200 * um,
            .cold_temperature = 300.0,
            .rise = 200.0,
            .frequency = 500.0};
}

TEST(ThermalLaminate, ObeysTheEquationInEachLayer) {
    const ThermalLaminate laminate(conductors());
    for (const double x : {3 * um, -17 * um, 45 * um, -100 * um}) {
        const bool inside = std::abs(x) < 30 * um;
        const double kappa = inside ? 0.05 : 0.4;
        const double capacity = inside ? 1e6 : 2.5e6;
        for (const double y : {-5 * um, -150 * um}) {
            const auto in_x = [&](double at) { return laminate.temperature(at, y, 1e-3); };
            const auto in_y = [&](double at) { return laminate.temperature(x, at, 1e-3); };
            const auto twice = [](const auto& f, double at) {
                return slope([&](double z) { return slope(f, z, 0.5 * um); }, at, 0.5 * um);
            };
            const double rate =
                slope([&](double t) { return laminate.temperature(x, y, t); }, 1e-3, 1e-5);
            const double conducted = kappa * (twice(in_x, x) + twice(in_y, y));
            EXPECT_NEAR(laminate.source(x, y, 1e-3), capacity * rate - conducted,
                        1e-6 * (std::abs(conducted) + std::abs(capacity * rate)));
        }
        const double through_surface =
            kappa * slope([&](double at) { return laminate.temperature(x, at, 1e-3); }, 0.0, um);
        const double law = inside ? laminate.inner_flux() : laminate.outer_flux();
        EXPECT_NEAR(law + laminate.further_flux(x, 1e-3), through_surface, 1e-9 * through_surface);
        EXPECT_NEAR(laminate.temperature(x, -200 * um, 1e-3), 300.0, 1e-9);
    }
}

TEST(ThermalLaminate, TemperatureAndFluxPassThroughTheInterfaces) {
    const ThermalLaminate laminate(conductors());
    const double t = 1e-3, y = -20 * um, h = 0.1 * um;
    for (const double side : {-30 * um, 30 * um}) {
        const auto at = [&](double x) { return laminate.temperature(side + x, y, t); };
        // One-sided differences of second order; what is left is their next term, (k h)^2.
        const double left = (3.0 * at(-1e-13) - 4.0 * at(-h) + at(-2.0 * h)) / (2.0 * h);
        const double right = (-3.0 * at(1e-13) + 4.0 * at(h) - at(2.0 * h)) / (2.0 * h);
        const double inside = side < 0.0 ? right : left;
        const double outside = side < 0.0 ? left : right;
        EXPECT_GT(std::abs(0.05 * inside), 1e4);
        EXPECT_NEAR(0.05 * inside, 0.4 * outside, 1e-4 * std::abs(0.05 * inside));
        const double crossing = std::copysign(laminate.crossing_heat(y, t), side);
        EXPECT_NEAR(0.05 * inside, crossing, 1e-4 * std::abs(crossing));
        EXPECT_NEAR(at(-1e-13), at(1e-13), 1e-5);
        EXPECT_NEAR(laminate.source(side - 1e-13, y, t), laminate.source(side + 1e-13, y, t),
                    1e-6 * std::abs(laminate.source(0.0, y, t)));
        EXPECT_NEAR(laminate.further_flux(side - 1e-13, t), laminate.further_flux(side + 1e-13, t),
                    1e-6 * laminate.outer_flux());
    }
    // The strip's temperature differs from the interface's by half the rise times the swing.
    EXPECT_NEAR(laminate.temperature(0.0, 0.0, 0.0), 300.0 + 200.0 * 0.5, 1e-9);
}

template <class Truth, class Parameters>
void expect_refused(Parameters parameters, double Parameters::*member, double value,
                    const std::string& name) {
    parameters.*member = value;
    try {
        Truth{parameters};
        ADD_FAILURE() << name << " = " << value << " was taken";
    } catch (const std::invalid_argument& refusal) {
        EXPECT_NE(std::string(refusal.what()).find(name), std::string::npos) << refusal.what();
    }
}

TEST(HeatTruths, RefuseWhatIsMissingOrOutOfRangeByName) {
    expect_refused<ManufacturedHeat>(deforming_solid(), &HeatedSolid::conductivity, missing,
                                     "conductivity");
    expect_refused<ManufacturedHeat>(deforming_solid(), &HeatedSolid::depth, 0.0, "depth");
    expect_refused<ManufacturedHeat>(deforming_solid(), &HeatedSolid::frequency, -1.0, "frequency");
    expect_refused<TravellingLayer>(half_space(), &BurningHalfSpace::flux, missing, "flux");
    expect_refused<TravellingLayer>(half_space(), &BurningHalfSpace::regression_rate, 0.0,
                                    "regression_rate");
    expect_refused<ThermalLaminate>(conductors(), &TwoConductors::inner_capacity, missing,
                                    "inner_capacity");
    expect_refused<ThermalLaminate>(conductors(), &TwoConductors::strip, 300 * um, "strip");
    EXPECT_THROW(TravellingLayer(half_space()).heating(0.0, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace crawford::reference
