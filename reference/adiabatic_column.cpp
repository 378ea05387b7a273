#include "reference/adiabatic_column.hpp"

#include <cmath>
#include <stdexcept>

#include "reference/require.hpp"
#include "reference/root.hpp"

namespace crawford::reference {
namespace {

/// Hotter than any solid; the capacity must be positive up to here, so that T has one answer.
constexpr double hottest = 1200.0;

/// The temperature at which `rising`, zero at the cold one, reaches `value`.
template <class Function>
double reached(const Function& rising, double cold, double value) {
    if (value == 0.0) return cold;
    if (rising(hottest) < value)
        throw std::invalid_argument("heat or pressure would bring the solid above 1200 K");
    return bracketed_root([&](double t) { return rising(t) - value; }, cold, hottest);
}

}  // namespace

AdiabaticColumn::AdiabaticColumn(const ConfinedSolid& solid) : solid_(solid) {
    require_positive("capacity", solid.capacity);
    require_not_negative("capacity_slope", solid.capacity_slope);
    require_positive("stress_work", solid.stress_work);
    require_not_negative("thermal_stress", solid.thermal_stress);
    require_finite("lame", solid.lame);
    require_positive("shear_modulus", solid.shear_modulus);
    require_positive("cold_temperature", solid.cold_temperature);
    require_positive("uniaxial_modulus", uniaxial_modulus());
    if (solid.capacity_slope * hottest >= solid.capacity)
        throw std::invalid_argument("capacity_slope must leave a capacity up to 1200 K");
}

double AdiabaticColumn::heated(double heat) const {
    require_not_negative("heat", heat);
    const double cold = solid_.cold_temperature;
    const double slope =
        solid_.stress_work * solid_.thermal_stress / uniaxial_modulus() - solid_.capacity_slope;
    const auto taken = [&](double t) {
        return (t - cold) * (solid_.capacity + 0.5 * slope * (t + cold));
    };
    return reached(taken, cold, heat);
}

double AdiabaticColumn::pressed(double pressure) const {
    require_not_negative("pressure", pressure);
    const double cold = solid_.cold_temperature;
    const double stiffness = uniaxial_modulus() / solid_.stress_work;
    const auto needed = [&](double t) {
        return stiffness * solid_.capacity * std::log(t / cold) +
               (solid_.thermal_stress - solid_.capacity_slope * stiffness) * (t - cold);
    };
    return reached(needed, cold, pressure);
}

double AdiabaticColumn::lateral_stress(double temperature, double pressure) const {
    const double thermal = solid_.thermal_stress * (temperature - solid_.cold_temperature);
    const double strain = (thermal - pressure) / uniaxial_modulus();
    return solid_.lame * strain - thermal;
}

}  // namespace crawford::reference
