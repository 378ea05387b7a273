#include "reference/flux_response.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "reference/require.hpp"

namespace crawford::reference {

namespace {

using Complex = std::complex<double>;

const SlabConditions& require_thermal(const SlabConditions& conditions) {
    if (conditions.model != SlabModel::thermal)
        throw std::invalid_argument(
            "model must be thermal: the closed form is that of a rigid slab");
    return conditions;
}

}  // namespace

double burn_rate_sensitivity(const SlabConditions& conditions, double surface_temperature) {
    if (conditions.regression == Regression::prescribed) return 0.0;
    return conditions.material.activation_temperature / (surface_temperature * surface_temperature);
}

FluxResponse::FluxResponse(const SlabConditions& conditions, double frequency)
    : slab_(require_thermal(conditions)),
      sensitivity_(burn_rate_sensitivity(conditions, slab_.surface_temperature())) {
    require_positive("frequency", frequency);
    const Material& m = conditions.material;
    const double rate = slab_.burn_rate();
    const double diffusivity = m.thermal_conductivity / (m.density * m.specific_heat);
    wave_number_ = rate / diffusivity;
    swing_ = slab_.state(0.0).temperature_gradient / wave_number_;
    angular_frequency_ = Complex(0.0, 2.0 * std::numbers::pi * frequency);
    root_ = std::sqrt(1.0 + 4.0 * angular_frequency_ * diffusivity / (rate * rate));

    // T'(0), C_1, C_2 from: T' at the surface is T'(0); the flux; T' = 0 at the bottom.
    const double kappa = m.thermal_conductivity;
    const Complex slope_1 = 0.5 * (1.0 + root_) * wave_number_;
    const Complex slope_2 = 0.5 * (1.0 - root_) * wave_number_;
    const double absorbed = m.heat_of_reaction * m.density * rate * sensitivity_;
    Eigen::Matrix3cd system = Eigen::Matrix3cd::Zero();
    system.row(0) << moved(0.0) - 1.0, rising(0.0), sinking(0.0);
    system.row(1) << kappa * wave_number_ * moved(0.0) - absorbed, kappa * slope_1 * rising(0.0),
        kappa * slope_2 * sinking(0.0);
    if (std::isinf(conditions.depth))
        system(2, 2) = 1.0;  // nothing comes up from a bottom that is not there
    else
        system.row(2) << moved(-conditions.depth), rising(-conditions.depth), 1.0;
    const Eigen::Vector3cd found =
        system.partialPivLu().solve(Eigen::Vector3cd(0.0, conditions.heat_flux, 0.0));
    surface_temperature_ = found[0];
    from_surface_ = found[1];
    from_bottom_ = found[2];
}

Complex FluxResponse::rising(double y) const {
    return std::exp(0.5 * (1.0 + root_) * wave_number_ * y);
}

Complex FluxResponse::sinking(double y) const {
    const double depth = slab_.conditions().depth;
    return std::isinf(depth) ? 0.0 : std::exp(0.5 * (1.0 - root_) * wave_number_ * (y + depth));
}

Complex FluxResponse::moved(double y) const {
    return -slab_.burn_rate() * sensitivity_ / angular_frequency_ * swing_ * wave_number_ *
           std::exp(wave_number_ * y);
}

Complex FluxResponse::temperature(double y) const {
    const double height = height_within(slab_.conditions(), y);
    return from_surface_ * rising(height) + from_bottom_ * sinking(height) +
           surface_temperature_ * moved(height);
}

}  // namespace crawford::reference
