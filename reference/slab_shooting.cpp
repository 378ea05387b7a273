#include "reference/slab_shooting.hpp"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "reference/root.hpp"
#include "reference/solved.hpp"

namespace crawford::reference {
namespace {

namespace odeint = boost::numeric::odeint;

/// D = T - T0 [K], flux kappa T' [W/m^2], v [m/s], sigma_11 [Pa].
using State = std::array<double, 4>;

/// The steady equations of the moving frame as a first-order system in y.
class Equations {
public:
    Equations(const SlabConditions& conditions, double burn_rate)
        : material_(conditions.material),
          model_(conditions.model),
          beta_(thermal_stress_modulus(conditions)),
          cold_(conditions.cold_temperature),
          given_back_(conditions.heat_capacity == HeatCapacity::constant_volume
                          ? beta_ * beta_ / material_.bulk_modulus
                          : 0.0),
          burn_rate_(burn_rate) {}

    void operator()(const State& state, State& rate, double /*y*/) const {
        const auto [rise, flux, velocity, stress] = state;
        const bool finite_strain =
            model_ == SlabModel::eulerian || model_ == SlabModel::mass_conserving;
        const double carrier = finite_strain ? burn_rate_ + velocity : burn_rate_;
        const double thickening =
            model_ == SlabModel::eulerian ? burn_rate_ + velocity : burn_rate_;
        const double slope = flux / material_.thermal_conductivity;
        // sigma_22 stays at -p_c: carrier sigma_22' = P v' - beta carrier T' = 0
        const double stretching = beta_ * carrier * slope / material_.uniaxial_modulus();
        rate[0] = slope;
        const double temperature = cold_ + rise;
        const double convection = material_.density * material_.specific_heat * thickening -
                                  given_back_ * temperature * carrier;
        rate[1] = convection * slope + beta_ * temperature * stretching;
        rate[2] = stretching;
        rate[3] = (material_.lame() * stretching - beta_ * carrier * slope) / carrier;
    }

    /// Growth rate of a small disturbance of the cold solid, D ~ exp(m y) [1/m].
    double cold_growth() const {
        State rate{};
        (*this)({0.0, 1.0, 0.0, 0.0}, rate, 0.0);
        return rate[1];
    }

private:
    Material material_;
    SlabModel model_;
    double beta_;
    double cold_;
    double given_back_;  // rho (c_p - c)/T [J/(m^3 K^2)]
    double burn_rate_;
};

/// Errors are measured against the state itself: its parts differ by fifteen decades.
odeint::bulirsch_stoer<State> make_stepper() {
    constexpr double absolute = 1e-30;
    constexpr double relative = 1e-13;
    return {absolute, relative};
}

/// How far below the surface of a half space the integration starts, in lengths of the cold tail.
constexpr double cold_foldings = 30.0;

/// One integration from the bottom to the surface.
class Shot {
public:
    Shot(const SlabConditions& conditions, double burn_rate, double flux)
        : conditions_(conditions),
          equations_(conditions, burn_rate),
          growth_(equations_.cold_growth()),
          flux_(flux),
          deep_(std::isinf(conditions.depth)),
          bottom_(deep_ ? -cold_foldings / growth_ : -conditions.depth) {}

    /// Where the integration starts [m].
    double bottom() const { return bottom_; }
    /// Slope (as log_slope_) that a slab with the properties of the cold solid would need.
    double linear_log_slope() const { return growth_ * bottom_; }

    State start(double log_slope) const {
        const double flux = flux_ * std::exp(log_slope);
        const double slope = flux / conditions_.material.thermal_conductivity;
        const Material& material = conditions_.material;
        State state{};
        state[0] = deep_ ? slope / growth_ : 0.0;
        state[1] = flux;
        const double theta = thermal_stress_modulus(conditions_) / material.uniaxial_modulus();
        state[3] = -material.lame() / material.uniaxial_modulus() * conditions_.pressure -
                   2.0 * material.shear_modulus * theta * state[0];
        return state;
    }

    /// State at the surface; stops early, with a flux far too large, where the solution runs away.
    State surface(double log_slope) const {
        auto stepper = make_stepper();
        State state = start(log_slope);
        double y = bottom_;
        double step = 0.1 / growth_;
        constexpr int most = 100'000;  // a hundred do in solids that burn
        for (int tries = 0; y < 0.0 && state[1] < 1e3 * flux_; ++tries) {
            if (tries == most) throw no_solution();
            step = std::min(step, -y);
            stepper.try_step(equations_, state, y, step);
        }
        return state;
    }

    /// States at ascending heights, the first of which is bottom().
    std::vector<State> along(double log_slope, const std::vector<double>& heights) const {
        std::vector<State> states;
        State state = start(log_slope);
        odeint::integrate_times(make_stepper(), equations_, state, heights.begin(), heights.end(),
                                0.1 / growth_,
                                [&](const State& s, double) { states.push_back(s); });
        return states;
    }

    /// Below the start of a half space the solution is its cold exponential.
    State below(double log_slope, double y) const {
        return start(log_slope + growth_ * (y - bottom_));
    }

private:
    const SlabConditions& conditions_;
    Equations equations_;
    double growth_;
    double flux_;
    bool deep_;  ///< a half space
    double bottom_;
};

double entering_flux(const SlabConditions& conditions, double burn_rate) {
    return conditions.heat_flux +
           conditions.material.heat_of_reaction * conditions.material.density * burn_rate;
}

}  // namespace

SlabShooting::SlabShooting(const SlabConditions& conditions) : conditions_(conditions) {
    require_valid(conditions_);
    if (conditions_.regression == Regression::prescribed) {
        surface_temperature_ = shoot(conditions_.burn_rate);
        return;
    }
    // Guess T_s, burn as the law says, and compare the T_s that comes out: hotter guesses burn
    // faster, which leaves less heat per volume. Come from the hot side: far below the answer so
    // much heat is left that at constant volume no slab could take it.
    const auto surprise = [&](double guess) {
        const double rate = burn_rate_at(conditions_, guess);
        if (entering_flux(conditions_, rate) <= 0.0) return conditions_.cold_temperature - guess;
        return shoot(rate) - guess;
    };
    double high = 4.0 * conditions_.cold_temperature;
    while (surprise(high) > 0.0) high *= 2.0;
    double low = 0.9 * high;
    while (surprise(low) < 0.0) {
        high = low;
        low *= 0.9;
    }
    surface_temperature_ = bracketed_root(surprise, low, high);
    shoot(burn_rate_at(conditions_, surface_temperature_));
}

/// T_s [K] that goes with a burn rate [m/s] and the flux it leaves.
double SlabShooting::shoot(double burn_rate) {
    burn_rate_ = burn_rate;
    const double flux = entering_flux(conditions_, burn_rate);
    const Shot shot(conditions_, burn_rate, flux);
    const auto overshoot = [&](double log_slope) {
        return std::log(shot.surface(log_slope)[1] / flux);
    };
    double high = shot.linear_log_slope() + 1e-3;
    double low = high - 1.0;
    while (overshoot(low) > 0.0) {
        high = low;
        low -= 1.0;
    }
    while (overshoot(high) < 0.0) {
        low = high;
        high += 1.0;
    }
    log_slope_ = bracketed_root(overshoot, low, high);
    return conditions_.cold_temperature + shot.surface(log_slope_)[0];
}

std::vector<ShotState> SlabShooting::states(std::span<const double> y) const {
    const Shot shot(conditions_, burn_rate_, entering_flux(conditions_, burn_rate_));
    std::vector<std::size_t> upwards;
    std::vector<State> found(y.size());
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double height = height_within(conditions_, y[i]);
        if (height > shot.bottom()) {
            upwards.push_back(i);
        } else {
            found[i] = shot.below(log_slope_, height);
        }
    }
    std::ranges::sort(upwards, [&](auto a, auto b) { return y[a] < y[b]; });
    std::vector<double> heights{shot.bottom()};
    for (const std::size_t i : upwards) heights.push_back(y[i]);
    const auto along = shot.along(log_slope_, heights);
    for (std::size_t k = 0; k < upwards.size(); ++k) found[upwards[k]] = along[k + 1];

    std::vector<ShotState> result;
    for (const State& state : found) {
        result.push_back({conditions_.cold_temperature + state[0], state[2], state[3]});
    }
    return result;
}

}  // namespace crawford::reference
