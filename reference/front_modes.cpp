#include "reference/front_modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/flux_response.hpp"
#include "reference/require.hpp"
#include "reference/slab.hpp"

namespace crawford::reference {

namespace {

using Complex = std::complex<double>;

/// The roots of x^3 + c_2 x^2 + c_1 x + c_0, as eigenvalues of its companion matrix.
Eigen::Vector3cd cubic_roots(double c_2, double c_1, double c_0) {
    Eigen::Matrix3d companion;
    companion << 0.0, 0.0, -c_0, 1.0, 0.0, -c_1, 0.0, 1.0, -c_2;
    Eigen::Vector3cd roots = Eigen::EigenSolver<Eigen::Matrix3d>(companion, false).eigenvalues();
    for (Complex& x : roots) {  // one step of Newton's takes off what the eigenvalues lost
        const Complex slope = (3.0 * x + 2.0 * c_2) * x + c_1;
        if (std::abs(slope) > 0.0) x -= (((x + c_2) * x + c_1) * x + c_0) / slope;
    }
    return roots;
}

}  // namespace

SteadyFront steady_front(const SlabConditions& conditions) {
    if (conditions.model != SlabModel::thermal)
        throw std::invalid_argument("model must be thermal: the modes are those of a rigid solid");
    if (conditions.regression != Regression::pyrolysis)
        throw std::invalid_argument("regression must be pyrolysis: nothing else answers the heat");
    if (!std::isinf(conditions.depth))
        throw std::invalid_argument("depth must be infinite: the modes are those of a half space");
    const Material& m = conditions.material;
    const Slab slab(conditions);
    const double rise = slab.surface_temperature() - conditions.cold_temperature;
    return {.burn_rate = slab.burn_rate(),
            .diffusivity = m.thermal_conductivity / (m.density * m.specific_heat),
            .cold_temperature = conditions.cold_temperature,
            .rise = rise,
            .sensitivity = rise * burn_rate_sensitivity(conditions, slab.surface_temperature()),
            .reaction = m.heat_of_reaction / (m.specific_heat * rise)};
}

double SteadyFront::temperature(double eta) const {
    return cold_temperature + rise * std::exp(wave_number() * eta);
}

Complex FrontMode::temperature(const SteadyFront& front, double eta) const {
    const double y = front.wave_number() * eta;
    return front.wave_number() * front.rise * (own_heat * std::exp(depth_decay * y) + std::exp(y));
}

std::vector<FrontMode> front_modes(const SteadyFront& front, double wave_number) {
    require_not_negative("wave_number", wave_number);
    const double z = front.sensitivity;
    const double gain = z * front.reaction;
    const double k2 = wave_number * wave_number;
    std::vector<FrontMode> modes;
    for (const Complex& root : cubic_roots(-1.0 - gain, gain + z - k2, k2 * gain - z)) {
        if (root.real() <= 0.0) continue;
        const Complex growth = root * root - root - k2;
        modes.push_back({.growth = growth,
                         .depth_decay = root,
                         .own_heat = -(1.0 + front.reaction * growth) / root});
    }
    std::ranges::sort(modes, [](const FrontMode& a, const FrontMode& b) {
        return a.growth.real() != b.growth.real() ? a.growth.real() > b.growth.real()
                                                  : a.growth.imag() > b.growth.imag();
    });
    return modes;
}

}  // namespace crawford::reference
