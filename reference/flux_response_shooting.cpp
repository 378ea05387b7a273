#include "reference/flux_response_shooting.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "reference/flux_response.hpp"
#include "reference/require.hpp"
#include "reference/slab_energy.hpp"

namespace crawford::reference {

namespace {

namespace odeint = boost::numeric::odeint;
using Complex = std::complex<double>;

/// T', T'_y and m' at one depth.
using Amplitude = Eigen::Vector3cd;

/// D [K], then the real and imaginary parts of T' [K], T'_y [K/m] and m' [m/s].
using State = std::array<double, 7>;

State state_of(double rise, const Amplitude& a) {
    return {rise, a[0].real(), a[0].imag(), a[1].real(), a[1].imag(), a[2].real(), a[2].imag()};
}
Amplitude amplitude_of(const State& s) {
    return {Complex(s[1], s[2]), Complex(s[3], s[4]), Complex(s[5], s[6])};
}

/// The linearised column; the steady slab is integrated beside it.
class Column {
public:
    Column(const Slab& slab, double frequency)
        : slab_(slab),
          energy_(slab.conditions()),
          kappa_(slab.conditions().material.thermal_conductivity),
          cold_capacity_(energy_.cold_capacity()),
          capacity_slope_(counted_stress_work(slab.conditions()) *
                          thermal_stress_modulus(slab.conditions()) * energy_.theta()),
          theta_(energy_.theta()),
          angular_(0.0, 2.0 * std::numbers::pi * frequency) {}

    void operator()(const State& state, State& rate, double /*y*/) const {
        const double rise = state[0];
        const Amplitude a = amplitude_of(state);
        const double carrier = carried(rise);
        const double slope = gradient(rise);
        const double heat_capacity = capacity(rise);
        const Complex material_rate = angular_ * a[0] + carrier * a[1] + slope * a[2];
        const Complex curvature =
            (heat_capacity * material_rate + capacity_slope_ * carrier * slope * a[0]) / kappa_;
        rate = state_of(slope, {a[1], curvature, theta_ * material_rate});
    }

    /// The steady profile, moved by a surface whose rate swings by 1 m/s.
    Amplitude moved(double rise) const {
        const double slope = gradient(rise);
        const double curvature = capacity(rise) * carried(rise) * slope / kappa_;
        return {-slope / angular_, -curvature / angular_,
                1.0 - theta_ * carried(rise) * slope / angular_};
    }

    double rise(double y) const { return slab_.state(y).rise; }

    /// How the cold solid's disturbances go with depth [1/m]: e^{root y}, the first fading
    /// downwards, the second upwards.
    std::array<Complex, 2> cold_roots() const {
        const double peclet = cold_capacity_ * slab_.burn_rate() / kappa_;
        const Complex root = std::sqrt(peclet * peclet + 4.0 * angular_ * cold_capacity_ / kappa_);
        return {0.5 * (peclet + root), 0.5 * (peclet - root)};
    }

private:
    double capacity(double rise) const { return cold_capacity_ + capacity_slope_ * rise; }
    double carried(double rise) const { return slab_.burn_rate() * std::exp(theta_ * rise); }
    double gradient(double rise) const {
        return (slab_.burn_rate() * energy_.heat_content(rise) + slab_.bottom_flux()) / kappa_;
    }

    const Slab& slab_;
    SlabEnergy energy_;
    double kappa_;
    double cold_capacity_;   // H(T_0) [J/(m^3 K)]
    double capacity_slope_;  // H_T [J/(m^3 K^2)]
    double theta_;
    Complex angular_;  // i w
};

/// After so many e-foldings a solution that fades is nothing.
constexpr double foldings = 36.0;

/// One of the two that fade away from where the other starts: T' = 0, T'_y = 1, m' = 0 at `start`.
class Shot {
public:
    Shot(const Column& column, double start, bool upwards)
        : column_(column), start_(start), upwards_(upwards) {}

    /// At these depths, in any order; zero beyond the start.
    std::vector<Amplitude> at(std::span<const double> y) const {
        std::vector<std::size_t> ahead;
        for (std::size_t i = 0; i < y.size(); ++i)
            if (upwards_ ? y[i] >= start_ : y[i] <= start_) ahead.push_back(i);
        std::ranges::sort(ahead, [&](auto a, auto b) { return upwards_ == (y[a] < y[b]); });
        std::vector<double> heights{start_};
        for (const std::size_t i : ahead)
            if (y[i] != heights.back()) heights.push_back(y[i]);

        constexpr double absolute = 1e-30;
        constexpr double relative = 1e-13;
        std::vector<Amplitude> along;
        State state = state_of(column_.rise(start_), {0.0, 1.0, 0.0});
        const double step = 0.1 / std::abs(column_.cold_roots()[0]);
        odeint::integrate_times(odeint::bulirsch_stoer<State>(absolute, relative), column_, state,
                                heights.begin(), heights.end(), upwards_ ? step : -step,
                                [&](const State& s, double) { along.push_back(amplitude_of(s)); });

        std::vector<Amplitude> found(y.size(), Amplitude::Zero());
        std::size_t k = 0;
        for (const std::size_t i : ahead) {
            if (y[i] != heights[k]) ++k;
            found[i] = along[k];
        }
        return found;
    }

private:
    const Column& column_;
    double start_;
    bool upwards_;
};

/// The three solutions at these depths; the last is zero without a bottom.
std::array<std::vector<Amplitude>, 3> solutions(const Column& column, double depth,
                                                std::span<const double> y) {
    const auto [falling, rising] = column.cold_roots();
    const double bottom = std::max(-depth, -foldings / falling.real());
    std::vector<Amplitude> moved;
    for (const double height : y) moved.push_back(column.moved(column.rise(height)));
    std::vector<Amplitude> none(y.size(), Amplitude::Zero());
    if (std::isinf(depth)) return {moved, Shot(column, bottom, true).at(y), none};
    const double top = std::min(0.0, -depth - foldings / rising.real());
    return {moved, Shot(column, bottom, true).at(y), Shot(column, top, false).at(y)};
}

const SlabConditions& require_linearised(const SlabConditions& conditions) {
    if (conditions.model != SlabModel::thermal && conditions.model != SlabModel::eulerian)
        throw std::invalid_argument("model must be thermal or eulerian");
    return conditions;
}

}  // namespace

FluxResponseShooting::FluxResponseShooting(const SlabConditions& conditions, double frequency)
    : slab_(require_linearised(conditions)),
      frequency_(frequency),
      sensitivity_(burn_rate_sensitivity(conditions, slab_.surface_temperature())) {
    require_positive("frequency", frequency);
    const Material& m = conditions.material;
    const double per_kelvin = slab_.burn_rate() * sensitivity_;  // r'/T'(0)
    const bool deep = std::isinf(conditions.depth);
    const Column column(slab_, frequency_);
    const std::array<double, 2> ends{0.0, deep ? 0.0 : -conditions.depth};
    const auto found = solutions(column, conditions.depth, ends);

    // T'(0) and the shares, from: T' at the surface is T'(0); the flux; T' = 0 and m' = r' at the
    // bottom. Without one, all that comes up is the moved profile, and m' = r' there.
    Eigen::Matrix4cd system = Eigen::Matrix4cd::Zero();
    system.col(0) << -1.0, -m.heat_of_reaction * m.density * per_kelvin, 0.0, -per_kelvin;
    for (int k = 0; k < 3; ++k) {
        const Amplitude& top = found[size_t(k)][0];
        const Amplitude& bottom = found[size_t(k)][1];
        system(0, k + 1) = top[0];
        system(1, k + 1) = m.thermal_conductivity * top[1];
        system(2, k + 1) = deep ? Complex(k == 2 ? 1.0 : 0.0) : bottom[0];
        system(3, k + 1) = deep ? Complex(k == 0 ? 1.0 : 0.0) : bottom[2];
    }
    // The solutions differ by many decades: columns of like size before the elimination.
    const Eigen::Vector4d size = system.cwiseAbs().colwise().maxCoeff();
    for (int k = 0; k < 4; ++k) system.col(k) /= size[k];
    Eigen::Vector4cd shares =
        system.fullPivLu().solve(Eigen::Vector4cd(0.0, conditions.heat_flux, 0.0, 0.0));
    shares = shares.cwiseQuotient(size.cast<Complex>());
    surface_temperature_ = shares[0];
    for (int k = 0; k < 3; ++k) share_[size_t(k)] = shares[k + 1];
}

Complex FluxResponseShooting::burn_rate() const {
    return sensitivity_ * surface_temperature_;
}

Complex FluxResponseShooting::surface_temperature() const {
    return surface_temperature_;
}

std::vector<Fluctuation> FluxResponseShooting::fluctuations(std::span<const double> y) const {
    std::vector<double> heights;
    for (const double height : y) heights.push_back(height_within(slab_.conditions(), height));
    const Column column(slab_, frequency_);
    const auto found = solutions(column, slab_.conditions().depth, heights);
    const Complex rate = slab_.burn_rate() * burn_rate();
    std::vector<Fluctuation> result;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        Amplitude sum = Amplitude::Zero();
        for (std::size_t k = 0; k < 3; ++k) sum += share_[k] * found[k][i];
        result.push_back({sum[0], sum[1], sum[2] - rate});
    }
    return result;
}

}  // namespace crawford::reference
