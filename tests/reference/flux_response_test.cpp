// A slab under a flame that swings: the closed form and the shooting, put back into their equations.
#include "reference/flux_response.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "reference/flux_response_shooting.hpp"

namespace crawford::reference {
namespace {

using Complex = std::complex<double>;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::array frequencies = {1.0, 10.0, 150.0, 5000.0, 5e4};

SlabConditions burning(const Material& material, SlabModel model, double depth) {
    return {.material = material,
            .model = model,
            .regression = Regression::pyrolysis,
            .heat_flux = 180.0 * calorie_per_second_per_cm2,
            .pressure = 2e6,
            .cold_temperature = 300.0,
            .depth = depth};
}

/// AP and binder, deep and shallow.
std::vector<SlabConditions> slabs(SlabModel model) {
    std::vector<SlabConditions> all;
    for (const Material& material : {ap(), binder()})
        for (const double depth : {infinite, 480e-6, 60e-6})
            all.push_back(burning(material, model, depth));
    return all;
}

/// What the linearised equations leave, against their largest term.
class Residual {
public:
    Residual& add(Complex term) {
        sum_ += term;
        largest_ = std::max(largest_, std::abs(term));
        return *this;
    }
    double relative() const { return std::abs(sum_) / largest_; }

private:
    Complex sum_ = 0.0;
    double largest_ = 0.0;
};

/// How fast things change with depth, beyond which differences are taken.
double fine_step(const SlabConditions& c, double frequency) {
    const Material& m = c.material;
    const double diffusivity = m.thermal_conductivity / (m.density * m.specific_heat);
    const double layer = diffusivity / Slab(c).burn_rate();
    return 2e-3 * std::min(layer, std::sqrt(diffusivity / (2.0 * std::numbers::pi * frequency)));
}

TEST(FluxResponse, ObeysTheLinearisedEquations) {
    for (const SlabConditions& c : slabs(SlabModel::thermal))
        for (const double frequency : frequencies) {
            const FluxResponse found(c, frequency);
            const Slab slab(c);
            const double h = fine_step(c, frequency);
            const double capacity = c.material.density * c.material.specific_heat;
            const Complex iw(0.0, 2.0 * std::numbers::pi * frequency);
            const Complex rate = slab.burn_rate() * found.burn_rate();
            for (const double y : {-2.0 * h, -5e-6, -30e-6}) {
                const Complex above = found.temperature(y + h);
                const Complex here = found.temperature(y);
                const Complex below = found.temperature(y - h);
                Residual heat;
                heat.add(capacity * iw * here)
                    .add(capacity * slab.burn_rate() * (above - below) / (2.0 * h))
                    .add(capacity * rate * slab.state(y).temperature_gradient)
                    .add(-c.material.thermal_conductivity * (above - 2.0 * here + below) / (h * h));
                EXPECT_LT(heat.relative(), 2e-5) << frequency << " Hz, y = " << y;
            }
            const Complex slope = (3.0 * found.temperature(0.0) - 4.0 * found.temperature(-h) +
                                   found.temperature(-2.0 * h)) /
                                  (2.0 * h);
            Residual flux;
            flux.add(c.material.thermal_conductivity * slope)
                .add(-c.heat_flux)
                .add(-c.material.heat_of_reaction * c.material.density * rate);
            EXPECT_LT(flux.relative(), 2e-5);
            EXPECT_LT(std::abs(found.temperature(0.0) / found.surface_temperature() - 1.0), 1e-11);
            const double deepest = std::isinf(c.depth) ? 3e-3 : c.depth;
            EXPECT_LT(std::abs(found.temperature(-deepest) / found.surface_temperature()), 1e-10);
        }
}

TEST(FluxResponse, IsTheSlopeOfTheSteadySlabsWhereTheSwingIsSlow) {
    for (const SlabModel model : {SlabModel::thermal, SlabModel::eulerian})
        for (const HeatCapacity capacity :
             {HeatCapacity::constant_pressure, HeatCapacity::constant_volume})
            for (SlabConditions c : slabs(model)) {
                c.heat_capacity = capacity;
                const auto log_rate = [&](double factor) {
                    SlabConditions heated = c;
                    heated.heat_flux *= factor;
                    return std::log(Slab(heated).burn_rate());
                };
                const double steady = (log_rate(1.001) - log_rate(0.999)) / 0.002;
                EXPECT_NEAR(FluxResponseShooting(c, 0.02).burn_rate().real(), steady, 2e-5);
                if (model == SlabModel::thermal) {
                    EXPECT_NEAR(FluxResponse(c, 0.02).burn_rate().real(), steady, 2e-5);
                }
            }
}

TEST(FluxResponse, ShootingFindsTheClosedFormWhereNothingExpands) {
    const std::vector<double> heights{-20e-6, 0.0, -60e-6, -1e-6, -0.3e-6};
    for (const SlabConditions& c : slabs(SlabModel::thermal))
        for (const double frequency : {1.0, 10.0, 150.0, 5000.0, 1e6}) {
            const FluxResponse closed(c, frequency);
            const FluxResponseShooting shot(c, frequency);
            EXPECT_LT(std::abs(shot.burn_rate() / closed.burn_rate() - 1.0), 1e-10);
            const auto found = shot.fluctuations(heights);
            for (size_t k = 0; k < heights.size(); ++k) {
                EXPECT_LT(std::abs(found[k].temperature - closed.temperature(heights[k])),
                          1e-10 * std::abs(closed.surface_temperature()));
                EXPECT_LT(std::abs(found[k].velocity),
                          1e-9 * shot.slab().burn_rate() * std::abs(shot.burn_rate()));
            }
        }
}

TEST(FluxResponse, ShootingObeysTheLinearisedEquations) {
    for (SlabConditions c : slabs(SlabModel::eulerian))
        for (const HeatCapacity reading :
             {HeatCapacity::constant_pressure, HeatCapacity::constant_volume})
            for (const double frequency : {10.0, 150.0, 5000.0}) {
                c.heat_capacity = reading;
                const FluxResponseShooting found(c, frequency);
                const Slab slab(c);
                const Material& m = c.material;
                const double h = fine_step(c, frequency);
                const Complex iw(0.0, 2.0 * std::numbers::pi * frequency);
                const Complex rate = slab.burn_rate() * found.burn_rate();
                const double beta = thermal_stress_modulus(c);
                const double deepest = std::isinf(c.depth) ? 3e-3 : c.depth;
                std::vector<double> heights{0.0, -deepest};
                for (const double y : {-2.0 * h, -5e-6, -30e-6})
                    heights.insert(heights.end(), {y - h, y, y + h});
                const auto all = found.fluctuations(heights);
                const auto all_steady = slab.states(heights);
                for (size_t first = 2; first < heights.size(); first += 3) {
                    const double y = heights[first + 1];
                    const std::span swing = std::span(all).subspan(first, 3);
                    const std::span steady = std::span(all_steady).subspan(first, 3);
                    const auto slope = [h](const auto& f) { return (f(2) - f(0)) / (2.0 * h); };
                    const auto swinging = [&](size_t k) { return swing[k].temperature; };
                    const auto velocity = [&](size_t k) { return swing[k].velocity; };
                    const auto resting = [&](size_t k) { return Complex(steady[k].velocity); };
                    const double carrier = slab.burn_rate() + steady[1].velocity;
                    const Complex steady_rate = carrier * steady[1].temperature_gradient;
                    const Complex material_rate =
                        iw * swinging(1) + carrier * slope(swinging) +
                        (rate + velocity(1)) * steady[1].temperature_gradient;

                    // 0 = P v_y - beta DT/Dt
                    Residual stress;
                    stress.add(m.uniaxial_modulus() * slope(velocity)).add(-beta * material_rate);
                    EXPECT_LT(stress.relative(), 2e-5) << frequency << " Hz, y = " << y;

                    // rho c DT/Dt = kappa T_yy - beta T v_y, c = c_p - beta^2 T/(rho K) or c_p
                    const double given_back = reading == HeatCapacity::constant_volume
                                                  ? beta * beta / m.bulk_modulus
                                                  : 0.0;
                    const double temperature = steady[1].temperature;
                    Residual heat;
                    heat.add((m.density * m.specific_heat - given_back * temperature) *
                             material_rate)
                        .add(-given_back * swinging(1) * steady_rate)
                        .add(-m.thermal_conductivity *
                             (swinging(2) - 2.0 * swinging(1) + swinging(0)) / (h * h))
                        .add(beta * temperature * slope(velocity))
                        .add(beta * swinging(1) * slope(resting));
                    EXPECT_LT(heat.relative(), 4e-5) << frequency << " Hz, y = " << y;
                }
                const std::span ends = std::span(all).first(2);
                Residual flux;
                flux.add(m.thermal_conductivity * ends[0].temperature_gradient)
                    .add(-c.heat_flux)
                    .add(-m.heat_of_reaction * m.density * rate);
                EXPECT_LT(flux.relative(), 1e-10);
                EXPECT_LT(std::abs(ends[0].temperature / found.surface_temperature() - 1.0), 1e-10);
                EXPECT_LT(std::abs(ends[1].temperature / ends[0].temperature), 1e-10);
                EXPECT_LT(std::abs(ends[1].velocity / rate), 1e-9);
            }
}

TEST(FluxResponse, OfApIsWhatExperimentsSee) {
    SlabConditions c = burning(ap(), SlabModel::thermal, infinite);
    c.heat_flux = 200.0 * calorie_per_second_per_cm2;
    const auto amplitude = [&](double f) { return std::abs(FluxResponse(c, f).burn_rate()); };
    EXPECT_NEAR(amplitude(0.02), 0.914, 1e-3);  // quasi-steady: model.md, typed in there
    EXPECT_GT(amplitude(160.0), amplitude(100.0));
    EXPECT_GT(amplitude(160.0), amplitude(250.0));
    EXPECT_LT(amplitude(5000.0), amplitude(1000.0));
}

TEST(FluxResponse, WithoutALawTheRateRestsWhileTheSurfaceSwings) {
    SlabConditions c = burning(ap(), SlabModel::thermal, infinite);
    c.regression = Regression::prescribed;
    c.burn_rate = 0.0045;
    const FluxResponse closed(c, 150.0);
    EXPECT_EQ(closed.burn_rate(), 0.0);
    EXPECT_GT(std::abs(closed.surface_temperature()), 1.0);
    const FluxResponseShooting shot(c, 150.0);
    EXPECT_LT(std::abs(shot.surface_temperature() / closed.surface_temperature() - 1.0), 1e-10);
}

TEST(FluxResponse, RefusesOtherModelsAndFrequencies) {
    SlabConditions c = burning(ap(), SlabModel::eulerian, infinite);
    EXPECT_THROW(FluxResponse(c, 100.0), std::invalid_argument);
    EXPECT_THROW(FluxResponseShooting(c, 0.0), std::invalid_argument);
    c.model = SlabModel::kuznetsov_stewart;
    EXPECT_THROW(FluxResponseShooting(c, 100.0), std::invalid_argument);
    c.model = SlabModel::thermal;
    EXPECT_THROW(FluxResponse(c, -1.0), std::invalid_argument);
}

}  // namespace
}  // namespace crawford::reference
