#include "reference/thermal_laminate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "reference/require.hpp"

namespace crawford::reference {

ThermalLaminate::ThermalLaminate(const TwoConductors& solid) : solid_(solid) {
    require_positive("inner_conductivity", solid.inner_conductivity);
    require_positive("outer_conductivity", solid.outer_conductivity);
    require_positive("inner_capacity", solid.inner_capacity);
    require_positive("outer_capacity", solid.outer_capacity);
    require_positive("strip", solid.strip);
    require_positive("width", solid.width);
    require_positive("depth", solid.depth);
    require_positive("cold_temperature", solid.cold_temperature);
    require_positive("rise", solid.rise);
    require_not_negative("frequency", solid.frequency);
    if (solid.strip >= solid.width)
        throw std::invalid_argument("strip must be narrower than the width");
    strength_ = 1.0;
    strength_ = 0.5 / std::max(std::abs(rises(0.0)), std::abs(rises(0.5 * solid.width)));
}

double ThermalLaminate::wave_number() const {
    return 2.0 * std::numbers::pi / solid_.width;
}

ThermalLaminate::Layer ThermalLaminate::layer(double x) const {
    const double from_the_axis = std::abs(std::remainder(x, solid_.width));
    return from_the_axis < 0.5 * solid_.strip
               ? Layer{solid_.inner_conductivity, solid_.inner_capacity}
               : Layer{solid_.outer_conductivity, solid_.outer_capacity};
}

double ThermalLaminate::rises(double x) const {
    const double at_the_interface = std::cos(0.5 * wave_number() * solid_.strip);
    return strength_ / (wave_number() * layer(x).conductivity) *
           (at_the_interface - std::cos(wave_number() * x));
}

double ThermalLaminate::swing(double t) const {
    return 1.0 + 0.5 * std::sin(solid_.frequency * t);
}

double ThermalLaminate::temperature(double x, double y, double t) const {
    return solid_.cold_temperature +
           solid_.rise * (1.0 + y / solid_.depth) * (1.0 + swing(t) * rises(x));
}

double ThermalLaminate::source(double x, double y, double t) const {
    const double stored =
        layer(x).capacity * 0.5 * solid_.frequency * std::cos(solid_.frequency * t) * rises(x);
    const double conducted = swing(t) * strength_ * wave_number() * std::cos(wave_number() * x);
    return solid_.rise * (1.0 + y / solid_.depth) * (stored - conducted);
}

double ThermalLaminate::inner_flux() const {
    return solid_.inner_conductivity * solid_.rise / solid_.depth;
}

double ThermalLaminate::outer_flux() const {
    return solid_.outer_conductivity * solid_.rise / solid_.depth;
}

double ThermalLaminate::crossing_heat(double y, double t) const {
    return solid_.rise * (1.0 + y / solid_.depth) * swing(t) * strength_ *
           std::sin(0.5 * wave_number() * solid_.strip);
}

double ThermalLaminate::further_flux(double x, double t) const {
    return layer(x).conductivity * solid_.rise / solid_.depth * swing(t) * rises(x);
}

}  // namespace crawford::reference
