// Small disturbances of the flat burning front, put back into the equations they were linearised from.
#include "reference/front_modes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "reference/flux_response.hpp"
#include "reference/front_ripple.hpp"
#include "reference/onset.hpp"

namespace crawford::reference {
namespace {

using Complex = std::complex<double>;

SlabConditions half_space(double heat_of_reaction, const Material& material = ap()) {
    SlabConditions c{.material = material,
                     .model = SlabModel::thermal,
                     .regression = Regression::pyrolysis,
                     .heat_flux = 200.0 * calorie_per_second_per_cm2,
                     .pressure = 0.0,
                     .cold_temperature = 300.0};
    c.material.heat_of_reaction = heat_of_reaction;
    return c;
}

/// A burning front and the heat below it, of a given amplitude [m].
struct Front {
    std::function<double(double amplitude, double x, double t)> surface;
    std::function<double(double amplitude, double x, double eta, double t)> temperature;
};

/// What an equation leaves, and its largest term: over several places, one of each.
struct Remainder {
    double left = 0.0, largest = 0.0;

    Remainder& operator+=(const Remainder& other) {
        left = std::max(left, other.left);
        largest = std::max(largest, other.largest);
        return *this;
    }
    double relative() const { return left / largest; }
};

/// The equations of heat and surface with nothing linearised, by differences: what they leave in
/// first order of the amplitude.
class Equations {
public:
    Equations(const SlabConditions& conditions, Front front, double amplitude, double length,
              double duration)
        : c_(conditions),
          front_(std::move(front)),
          amplitude_(amplitude),
          h_(2e-3 * length),
          dt_(2e-3 * duration) {}

    /// rho c T_t - kappa (T_xx + T_yy)
    Remainder heat(double x, double y, double t) const {
        const double capacity = c_.material.density * c_.material.specific_heat;
        const double kappa = c_.material.thermal_conductivity;
        return odd([&](double a) {
            const auto at = [&](double i, double j, double k) {
                return temperature(a, x + i * h_, y + j * h_, t + k * dt_);
            };
            const auto second = [&](double i, double j) {
                return (at(i, j, 0) - 2.0 * at(0, 0, 0) + at(-i, -j, 0)) / (h_ * h_);
            };
            return std::array{capacity * (at(0, 0, 1) - at(0, 0, -1)) / (2.0 * dt_),
                              -kappa * second(1, 0), -kappa * second(0, 1)};
        });
    }

    /// phi_t + r(T) sqrt(1 + phi_x^2)
    Remainder motion(double x, double t) const {
        return odd([&](double a) {
            const auto phi = [&](double i, double k) {
                return front_.surface(a, x + i * h_, t + k * dt_);
            };
            return std::array{(phi(0, 1) - phi(0, -1)) / (2.0 * dt_),
                              rate(a, x, t) * std::hypot(1.0, slope(a, x, t)), 0.0};
        });
    }

    /// kappa n.grad T - Q - q_s rho r(T)
    Remainder flux(double x, double t) const {
        const Material& m = c_.material;
        return odd([&](double a) {
            const double phi_x = slope(a, x, t);
            // The modes are smooth beyond the surface, too.
            const double y = front_.surface(a, x, t);
            const double t_x =
                (temperature(a, x + h_, y, t) - temperature(a, x - h_, y, t)) / (2.0 * h_);
            const double t_y =
                (temperature(a, x, y + h_, t) - temperature(a, x, y - h_, t)) / (2.0 * h_);
            return std::array{m.thermal_conductivity * (t_y - phi_x * t_x) / std::hypot(1.0, phi_x),
                              -c_.heat_flux, -m.heat_of_reaction * m.density * rate(a, x, t)};
        });
    }

private:
    double temperature(double a, double x, double y, double t) const {
        return front_.temperature(a, x, y - front_.surface(a, x, t), t);
    }
    double slope(double a, double x, double t) const {
        return (front_.surface(a, x + h_, t) - front_.surface(a, x - h_, t)) / (2.0 * h_);
    }
    double rate(double a, double x, double t) const {
        return c_.material.pyrolysis_prefactor *
               std::exp(-c_.material.activation_temperature / front_.temperature(a, x, 0.0, t));
    }

    template <class Terms>
    Remainder odd(const Terms& terms) const {
        const auto up = terms(amplitude_);
        const auto down = terms(-amplitude_);
        double sum = 0.0;
        double largest = 0.0;
        for (size_t k = 0; k < up.size(); ++k) {
            sum += up[k] - down[k];
            largest = std::max(largest, std::abs(up[k] - down[k]));
        }
        return {std::abs(sum), largest};
    }

    SlabConditions c_;
    Front front_;
    double amplitude_, h_, dt_;
};

TEST(FrontRipple, ObeysTheEquationsToSecondOrder) {
    for (const Material& material : {ap(), binder()})
        for (const double width : {60e-6, 240e-6, 1e-3}) {
            const double k = 2.0 * std::numbers::pi / width;
            const SlabConditions c = half_space(material.heat_of_reaction, material);
            const FrontRipple ripple(c, k);
            const SteadyFront& steady = ripple.front();
            const auto height = [&](double a, double x, double t) {
                return a * std::cos(k * x) * std::exp(ripple.growth_rate() * t);
            };
            const Front front{[&](double a, double x, double t) {
                                  return height(a, x, t) - steady.burn_rate * t;
                              },
                              [&](double a, double x, double eta, double t) {
                                  return steady.temperature(eta) +
                                         height(a, x, t) * ripple.temperature(eta);
                              }};
            EXPECT_LT(ripple.growth_rate(), 0.0);
            const double length = std::min(1.0 / steady.wave_number(), 1.0 / k);
            const double duration = std::min(1.0 / steady.rate_unit(), -1.0 / ripple.growth_rate());
            const Equations equations(c, front, 1e-4 * length, length, duration);
            const double t = 0.3 * duration;
            Remainder heat;
            Remainder motion;
            Remainder flux;
            for (const double x : {0.1 * width, 0.45 * width}) {
                heat += equations.heat(x, front.surface(0.0, x, t) - 0.7 * length, t);
                motion += equations.motion(x, t);
                flux += equations.flux(x, t);
            }
            for (const Remainder& r : {heat, motion, flux}) EXPECT_LT(r.relative(), 3e-5);
        }
}

TEST(SwingingFront, ObeysTheEquationsToSecondOrder) {
    for (const double of_onset : {0.8, 1.0, 1.1}) {
        const SlabConditions c = half_space(of_onset * heat_of_reaction_at_onset(half_space(0.0)));
        const SwingingFront exact(c);
        const SteadyFront& steady = exact.front();
        const auto swing = [&](double a, double t) {
            return a * std::exp(exact.growth_rate() * t);
        };
        const Front front{
            [&](double a, double, double t) { return swing(a, t).real() - steady.burn_rate * t; },
            [&](double a, double, double eta, double t) {
                return steady.temperature(eta) + (swing(a, t) * exact.temperature(eta)).real();
            }};
        const double length = 1.0 / steady.wave_number();
        const double duration = 1.0 / std::abs(exact.growth_rate());
        const Equations equations(c, front, 1e-4 * length, length, duration);
        Remainder heat;
        Remainder motion;
        Remainder flux;
        for (const double t : {0.0, 0.4 * duration, 0.8 * duration, 1.2 * duration}) {
            heat += equations.heat(0.0, front.surface(0.0, 0.0, t) - 0.7 * length, t);
            motion += equations.motion(0.0, t);
            flux += equations.flux(0.0, t);
        }
        for (const Remainder& r : {heat, motion, flux}) EXPECT_LT(r.relative(), 3e-5);
    }
}

TEST(SwingingFront, GrowsFromTheOnsetOn) {
    const double onset = heat_of_reaction_at_onset(half_space(0.0));
    EXPECT_NEAR(onset, 0.457e6, 0.001e6);  // found before, by another program
    EXPECT_LT(SwingingFront(half_space(0.99 * onset)).growth_rate().real(), 0.0);
    EXPECT_GT(SwingingFront(half_space(1.01 * onset)).growth_rate().real(), 0.0);
    const SwingingFront at_it(half_space(onset));
    EXPECT_LT(std::abs(at_it.growth_rate().real()), 1e-9 * at_it.growth_rate().imag());
}

TEST(FrontModes, ObeyTheDispersionRelation) {
    for (const double q : {-0.4e6, 0.0, 0.3e6, 0.46e6}) {
        const SteadyFront front = steady_front(half_space(q));
        const double z = front.sensitivity;
        for (const double k : {0.0, 0.05, 0.9, 7.0}) {
            const auto modes = front_modes(front, k);
            ASSERT_FALSE(modes.empty());
            for (const FrontMode& mode : modes) {
                const Complex l = mode.depth_decay;
                const Complex s = mode.growth;
                EXPECT_GT(l.real(), 0.0);
                EXPECT_LT(std::abs((l - 1.0) * z + l * s - z * front.reaction * s),
                          1e-12 * (std::abs(l * z) + std::abs(l * s)));
                EXPECT_LE(s.real(), modes.front().growth.real());
            }
        }
    }
}

TEST(FrontModes, WithoutRipplesAreTheFrontMovedAndItsSwing) {
    const SwingingFront swinging(half_space(0.4e6));
    const SteadyFront& front = swinging.front();
    const auto modes = front_modes(front, 0.0);
    ASSERT_EQ(modes.size(), 3);
    EXPECT_LT(std::abs(modes[0].growth), 1e-12);
    EXPECT_LT(std::abs(modes[0].temperature(front, -1e-5)),
              1e-9 * front.rise * front.wave_number());
    EXPECT_LT(std::abs(modes[1].growth * front.rate_unit() / swinging.growth_rate() - 1.0), 1e-12);
    EXPECT_LT(std::abs(modes[2].growth - std::conj(modes[1].growth)), 1e-12);
}

TEST(FrontModes, LongRipplesDieByConductionAlone) {
    const SteadyFront front = steady_front(half_space(-0.2e6));
    const double k = 1e-3;
    const double z = front.sensitivity;
    EXPECT_NEAR(front_modes(front, k).front().growth.real() / (k * k),
                -z / (1.0 + z * (1.0 - front.reaction)), 1e-5);
}

TEST(FrontModes, RefuseWhatHasNone) {
    const auto refused = [](const auto& change) {
        SlabConditions c = half_space(0.0);
        change(c);
        EXPECT_THROW(steady_front(c), std::invalid_argument);
    };
    refused([](SlabConditions& c) { c.model = SlabModel::eulerian; });
    refused([](SlabConditions& c) { c.depth = 1e-3; });
    refused([](SlabConditions& c) {
        c.regression = Regression::prescribed;
        c.burn_rate = 1e-3;
    });
    EXPECT_THROW(front_modes(steady_front(half_space(0.0)), -1.0), std::invalid_argument);
    EXPECT_THROW(FrontRipple(half_space(0.0), 0.0), std::invalid_argument);
    EXPECT_THROW(FrontRipple(half_space(0.46e6), 100.0), std::invalid_argument);
    EXPECT_THROW(SwingingFront(half_space(0.0)), std::invalid_argument);
}

}  // namespace
}  // namespace crawford::reference
