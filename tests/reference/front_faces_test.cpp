/// The common face of the truths of a moving front tells what their classes tell.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "reference/flux_response.hpp"
#include "reference/flux_response_shooting.hpp"
#include "reference/front_ripple.hpp"
#include "reference/onset.hpp"
#include "reference/truth_registry.hpp"

namespace crawford::reference {

namespace {

using Complex = std::complex<double>;

constexpr double x = 31e-6;
constexpr double y = -47e-6;
constexpr double t = 2e-3;
constexpr double flux = 7e6;

FieldTable at(const char* name, const Parameters& given) {
    return truth(name, given).values(std::vector{Eigen::Vector2d(x, y)}, t);
}

double of(const FieldTable& table, const char* field) {
    return table.column(field).front();
}

SlabConditions burning(const Material& material, SlabModel model) {
    return {.material = material,
            .model = model,
            .regression = Regression::pyrolysis,
            .heat_flux = flux,
            .pressure = 0.0,
            .cold_temperature = 310.0};
}

const Parameters common{{"heat_flux", flux}, {"cold_temperature", 310.0}};

Parameters with(Parameters more) {
    more.insert(common.begin(), common.end());
    return more;
}

double swung(Complex amplitude, double frequency) {
    const double angle = 2.0 * std::numbers::pi * frequency * t;
    return 0.02 * (amplitude * std::exp(Complex(0.0, angle))).real();
}

TEST(FrontFaces, FluxResponse) {
    SlabConditions c = burning(binder(), SlabModel::thermal);
    c.depth = 300e-6;
    const FluxResponse response(c, 70.0);
    const FieldTable table = at(
        "flux-response",
        with(
            {{"material", "binder"}, {"depth", 300e-6}, {"frequency", 70.0}, {"amplitude", 0.02}}));
    const Slab& slab = response.slab();
    EXPECT_DOUBLE_EQ(of(table, "temperature"),
                     slab.temperature(y) + swung(response.temperature(y), 70.0));
    EXPECT_DOUBLE_EQ(of(table, "surface_temperature"),
                     slab.surface_temperature() + swung(response.surface_temperature(), 70.0));
    EXPECT_DOUBLE_EQ(of(table, "burn_rate"),
                     slab.burn_rate() * (1.0 + swung(response.burn_rate(), 70.0)));
    EXPECT_EQ(of(table, "burn_rate_response"), std::abs(response.burn_rate()));
    EXPECT_EQ(of(table, "burn_rate_lead"), std::arg(response.burn_rate()));
}

TEST(FrontFaces, FluxResponseShooting) {
    SlabConditions c = burning(binder(), SlabModel::eulerian);
    c.heat_capacity = HeatCapacity::constant_volume;
    c.thermal_stress = ThermalStress::alpha_k;
    const FluxResponseShooting response(c, 70.0);
    const Fluctuation swing = response.fluctuations(std::vector{y}).front();
    const SlabState steady = response.slab().state(y);
    const FieldTable table = at("flux-response-shooting", with({{"material", "binder"},
                                                                {"heat_capacity", "c_v"},
                                                                {"thermal_stress", "alpha K"},
                                                                {"frequency", 70.0},
                                                                {"amplitude", 0.02}}));
    EXPECT_DOUBLE_EQ(of(table, "temperature"), steady.temperature + swung(swing.temperature, 70.0));
    EXPECT_DOUBLE_EQ(of(table, "velocity_y"), steady.velocity + swung(swing.velocity, 70.0));
    EXPECT_EQ(of(table, "velocity_x"), 0.0);
    EXPECT_EQ(of(table, "burn_rate_response"), std::abs(response.burn_rate()));
}

TEST(FrontFaces, FrontRipple) {
    const double k = 2.0 * std::numbers::pi * 3.0 / 200e-6;
    const FrontRipple ripple(burning(ap(), SlabModel::thermal), k);
    const FieldTable table =
        at("front-ripple", with({{"width", 200e-6}, {"waves", 3.0}, {"amplitude", 2e-7}}));
    const double height = 2e-7 * std::cos(k * x) * std::exp(ripple.growth_rate() * t);
    const double surface = height - ripple.front().burn_rate * t;
    EXPECT_DOUBLE_EQ(of(table, "surface"), surface);
    EXPECT_DOUBLE_EQ(of(table, "temperature"), ripple.front().temperature(y - surface) +
                                                   height * ripple.temperature(y - surface));
    EXPECT_EQ(of(table, "growth_rate"), ripple.growth_rate());
    EXPECT_EQ(of(table, "burn_rate"), ripple.front().burn_rate);
}

TEST(FrontFaces, SwingingFront) {
    SlabConditions c = burning(ap(), SlabModel::thermal);
    c.material.heat_of_reaction = 0.44e6;
    const SwingingFront front(c);
    const FieldTable table = at("swinging-front", with({{"heat_of_reaction", 0.44e6}}));
    const Complex swing = 1e-8 * std::exp(front.growth_rate() * t);
    const double surface = swing.real() - front.front().burn_rate * t;
    EXPECT_DOUBLE_EQ(of(table, "surface"), surface);
    EXPECT_DOUBLE_EQ(of(table, "temperature"), front.front().temperature(y - surface) +
                                                   (swing * front.temperature(y - surface)).real());
    EXPECT_EQ(of(table, "growth_rate"), front.growth_rate().real());
    EXPECT_EQ(of(table, "angular_frequency"), front.growth_rate().imag());
    EXPECT_EQ(of(table, "burn_rate"), front.front().burn_rate);
    EXPECT_EQ(of(table, "heat_of_reaction_at_onset"), heat_of_reaction_at_onset(c));
}

}  // namespace

}  // namespace crawford::reference
