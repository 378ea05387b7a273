#include "solver/guards/steady_slab.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crawford {

namespace {

double beta(const Material& m, ThermalStress reading) {
    const double of_one = m.thermal_expansion * m.bulk_modulus;
    return reading == ThermalStress::three_alpha_bulk ? 3.0 * of_one : of_one;
}

class Balance {
public:
    Balance(const Scene& scene, size_t number)
        : scene_(scene),
          material_(scene.morphology.materials[number]),
          flux_(scene.surface.heat_flux[number]),
          solid_(coupled(material_, scene.numerics)) {}

    double rate(double surface) const {
        if (scene_.physics.regression == Regression::fixed) return scene_.surface.burn_rate;
        return material_.pyrolysis_prefactor *
               std::exp(-material_.activation_temperature / surface);
    }

    /// What a surface this hot needs, less what it gets [W/m^2].
    double lacking(double surface) const {
        const double absorbed = material_.heat_of_reaction * material_.density;
        return rate(surface) * (heat_taken(surface) - absorbed) - flux_;
    }

private:
    /// The integral of the header, of rho c + w T with both constant [J/m^3]; c_v = c_p - beta_w^2
    /// T/(rho K) takes some of w away again.
    double heat_taken(double surface) const {
        const double start = scene_.bottom.temperature;
        const double rise = surface - start;
        if (!scene_.physics.mechanics) return solid_.heat_capacity * rise;
        const double theta = solid_.stress_of_heat / material_.uniaxial_modulus();
        double w = solid_.heat_of_stretch * theta;
        if (scene_.numerics.heat_capacity == HeatCapacity::constant_volume)
            w -= solid_.heat_of_stretch * solid_.heat_of_stretch / solid_.bulk_modulus;
        if (theta == 0.0) return solid_.heat_capacity * rise + w * rise * (start + 0.5 * rise);
        const double grown = std::expm1(theta * rise) / theta;
        return (solid_.heat_capacity + w * start - w / theta) * grown +
               w * rise * std::exp(theta * rise) / theta;
    }

    const Scene& scene_;
    const Material& material_;
    double flux_;
    CoupledSolid solid_;
};

/// Where between two temperatures nothing is lacking: at the lower one something is.
double root_between(const Balance& balance, double low, double high) {
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        (balance.lacking(middle) >= 0.0 ? high : low) = middle;
    }
    return high;
}

/// The coolest surface above `cold` that lacks nothing. An exothermic one may have several.
std::optional<double> coolest_root(const Balance& balance, double cold) {
    constexpr int parts = 400;
    double low = cold;
    for (int k = 1; k <= parts; ++k) {
        const double high = cold * std::pow(hottest_surface / cold, double(k) / parts);
        if (balance.lacking(high) >= 0.0) return root_between(balance, low, high);
        low = high;
    }
    return std::nullopt;
}

/// What a surface hotter than all that is looked for would have to be; infinite where none would do.
double beyond_the_hottest(const Balance& balance) {
    constexpr double nowhere = 1e12;
    double low = hottest_surface;
    while (low < nowhere) {
        const double high = 2.0 * low;
        if (balance.lacking(high) >= 0.0) return root_between(balance, low, high);
        low = high;
    }
    return std::numeric_limits<double>::infinity();
}

}  // namespace

CoupledSolid coupled(const Material& m, const Numerics& numerics) {
    return {.heat_capacity = m.density * m.specific_heat,
            .bulk_modulus = m.bulk_modulus,
            .shear_modulus = m.shear_modulus,
            .stress_of_heat = beta(m, numerics.thermal_stress),
            .heat_of_stretch = beta(m, numerics.stress_work)};
}

double heat_capacity(const CoupledSolid& solid, HeatCapacity reading, double temperature) {
    if (reading == HeatCapacity::constant_pressure) return solid.heat_capacity;
    return solid.heat_capacity - solid.split_capacity(temperature);
}

double zeldovich_number(double activation_temperature, double hot, double cold) {
    return activation_temperature * (hot - cold) / (hot * hot);
}

double largest_activation(const Scene& scene) {
    if (scene.physics.regression != Regression::pyrolysis) return 0.0;
    double largest = 0.0;
    for (const Material& m : scene.morphology.materials)
        largest = std::max(largest, m.activation_temperature);
    return largest;
}

double speed_of_expansion(const Scene& scene, const Material& material, const SteadySlab& slab) {
    const double theta =
        coupled(material, scene.numerics).stress_of_heat / material.uniaxial_modulus();
    return slab.burn_rate *
           std::expm1(theta * (slab.surface_temperature - scene.bottom.temperature));
}

SlabAnswer steady_slab(const Scene& scene, size_t material) {
    const bool burns = scene.physics.heat && scene.physics.regression != Regression::none;
    if (!burns || scene.surface.heat_flux[material] <= 0.0) return {Burning::none, {}};
    const Balance balance(scene, material);
    const auto answer = [&](Burning burning, double surface) {
        return SlabAnswer{burning, {surface, balance.rate(surface)}};
    };
    const double cold = scene.bottom.temperature;
    if (balance.lacking(cold) > 0.0)
        return answer(Burning::too_cold, root_between(balance, 0.0, cold));
    if (const auto surface = coolest_root(balance, cold)) return answer(Burning::steady, *surface);
    return answer(Burning::too_hot, beyond_the_hottest(balance));
}

}  // namespace crawford
