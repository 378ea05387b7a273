#include "reference/manufactured_heat.hpp"

#include <boost/math/differentiation/autodiff.hpp>

#include "reference/require.hpp"

namespace crawford::reference {
namespace {

using boost::math::differentiation::make_fvar;

/// The value and derivatives, up to `order`, of a function of one variable.
template <std::size_t order, class Function>
std::array<double, order + 1> differentiate(const Function& f, double at) {
    const auto value = f(make_fvar<double, order>(at));
    std::array<double, order + 1> result;
    for (std::size_t k = 0; k <= order; ++k) result[k] = value.derivative(k);
    return result;
}

}  // namespace

ManufacturedHeat::ManufacturedHeat(const HeatedSolid& solid) : solid_(solid) {
    require_positive("conductivity", solid.conductivity);
    require_positive("capacity", solid.capacity);
    require_not_negative("stress_work", solid.stress_work);
    require_not_negative("capacity_slope", solid.capacity_slope);
    require_positive("width", solid.width);
    require_positive("depth", solid.depth);
    require_positive("cold_temperature", solid.cold_temperature);
    require_not_negative("rise", solid.rise);
    require_not_negative("frequency", solid.frequency);
    require_finite("surface_wave", solid.surface_wave);
    require_finite("regression_rate", solid.regression_rate);
    require_finite("speed", solid.speed);
}

double ManufacturedHeat::surface_rate(double x, double t) const {
    return differentiate<1>([&](const auto& at) { return surface(x, at); }, t)[1];
}

double ManufacturedHeat::divergence(double x, double y, double t) const {
    const auto u = [&](const auto& at) { return velocity(at, y, t)[0]; };
    const auto v = [&](const auto& at) { return velocity(x, at, t)[1]; };
    return differentiate<1>(u, x)[1] + differentiate<1>(v, y)[1];
}

ManufacturedHeat::Derivatives ManufacturedHeat::derivatives_of_temperature(double x, double y,
                                                                           double t) const {
    const auto in_x = differentiate<2>([&](const auto& at) { return temperature(at, y, t); }, x);
    const auto in_y = differentiate<2>([&](const auto& at) { return temperature(x, at, t); }, y);
    const auto in_t = differentiate<1>([&](const auto& at) { return temperature(x, y, at); }, t);
    return {in_x[1], in_y[1], in_t[1], in_x[2] + in_y[2]};
}

double ManufacturedHeat::material_rate(double x, double y, double t) const {
    const auto [u, v] = velocity(x, y, t);
    const Derivatives d = derivatives_of_temperature(x, y, t);
    return d.t + u * d.x + v * d.y;
}

double ManufacturedHeat::source(double x, double y, double t) const {
    const auto [u, v] = velocity(x, y, t);
    const Derivatives d = derivatives_of_temperature(x, y, t);
    const double at = temperature(x, y, t);
    return (solid_.capacity - solid_.capacity_slope * at) * (d.t + u * d.x + v * d.y) -
           solid_.conductivity * d.laplacian + solid_.stress_work * at * divergence(x, y, t);
}

double ManufacturedHeat::surface_flux(double x, double t) const {
    const double slope = differentiate<1>([&](const auto& at) { return surface(at, t); }, x)[1];
    const Derivatives d = derivatives_of_temperature(x, surface(x, t), t);
    return solid_.conductivity * (d.y - slope * d.x) / std::hypot(1.0, slope);
}

}  // namespace crawford::reference
