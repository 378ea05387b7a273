#include "reference/travelling_layer.hpp"

#include <cmath>
#include <numbers>

#include "reference/require.hpp"

namespace crawford::reference {

TravellingLayer::TravellingLayer(const BurningHalfSpace& solid) : solid_(solid) {
    require_positive("conductivity", solid.conductivity);
    require_positive("capacity", solid.capacity);
    require_positive("regression_rate", solid.regression_rate);
    require_finite("flux", solid.flux);
    require_positive("cold_temperature", solid.cold_temperature);
}

double TravellingLayer::thickness() const {
    return solid_.conductivity / (solid_.regression_rate * solid_.capacity);
}

double TravellingLayer::steady(double eta, double depth) const {
    require_positive("depth", depth);
    const double rise = solid_.flux / (solid_.regression_rate * solid_.capacity);
    return solid_.cold_temperature +
           rise * (std::exp(eta / thickness()) - std::exp(-depth / thickness()));
}

double TravellingLayer::heating(double eta, double t) const {
    require_positive("t", t);
    const double reach = 2.0 * std::sqrt(solid_.conductivity / solid_.capacity * t);
    const double a = (-eta + solid_.regression_rate * t) / reach;
    const double b = (-eta - solid_.regression_rate * t) / reach;
    const double ierfc = std::exp(-a * a) / std::sqrt(std::numbers::pi) - a * std::erfc(a);
    const double layer = thickness() * (std::exp(eta / thickness()) * std::erfc(b) - std::erfc(a));
    return solid_.cold_temperature +
           0.5 * solid_.flux / solid_.conductivity * (reach * ierfc + layer);
}

}  // namespace crawford::reference
