#include "solver/burning/burn_rate.hpp"

#include <cmath>

namespace crawford {

double BurningLaw::material_rate(const Material& material, double temperature) const {
    switch (regression_) {
        case Regression::pyrolysis:
            return material.pyrolysis_prefactor *
                   std::exp(-material.activation_temperature / temperature);
        case Regression::fixed:
            return surface_.burn_rate;
        case Regression::none:
            break;
    }
    return 0.0;
}

/// d r_b/dT [m/(s K)]
double BurningLaw::material_rate_slope(const Material& material, double temperature) const {
    if (regression_ != Regression::pyrolysis) return 0.0;
    return material_rate(material, temperature) * material.activation_temperature /
           (temperature * temperature);
}

double BurningLaw::burn_rate(const MaterialMap& materials, double fraction,
                             double temperature) const {
    return fraction * material_rate(materials.first(), temperature) +
           (1.0 - fraction) * material_rate(materials.second(), temperature);
}

LinearFlux BurningLaw::heat_flux(const MaterialMap& materials, double fraction,
                                 double temperature) const {
    const auto absorbed = [&](const auto& rate) {
        const auto of = [&](const Material& m) { return m.heat_of_reaction * m.density * rate(m); };
        return fraction * of(materials.first()) + (1.0 - fraction) * of(materials.second());
    };
    const double gas =
        fraction * surface_.heat_flux.front() + (1.0 - fraction) * surface_.heat_flux.back();
    return {gas + absorbed([&](const Material& m) { return material_rate(m, temperature); }),
            absorbed([&](const Material& m) { return material_rate_slope(m, temperature); })};
}

SurfaceField BurningLaw::burn_rate(const Grid& grid, const MaterialMap& materials,
                                   const NodeField& temperature) const {
    const int top = grid.rows();
    SurfaceField mean_fraction(size_t(grid.node_columns()), 0.0);
    SurfaceField cells_beside(size_t(grid.node_columns()), 0.0);
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (const int node : {i, grid.right_node(i)}) {
            mean_fraction[size_t(node)] += materials.fraction()(i, top - 1);
            cells_beside[size_t(node)] += 1.0;
        }
    SurfaceField rate(size_t(grid.node_columns()));
    for (int i = 0; i < grid.node_columns(); ++i) {
        const double surface_temperature = temperature.empty() ? 0.0 : temperature(i, top);
        rate[size_t(i)] = burn_rate(materials, mean_fraction[size_t(i)] / cells_beside[size_t(i)],
                                    surface_temperature);
    }
    return rate;
}

double mean_burn_rate(const Grid& grid, const SurfaceField& surface,
                      const SurfaceField& burn_rate) {
    double burnt = 0.0;
    double length = 0.0;
    for (int i = 0; i < grid.cell_columns(); ++i) {
        const double segment = grid.dx(i) * std::hypot(1.0, grid.slope(surface, i));
        burnt += 0.5 * segment * (burn_rate[size_t(i)] + burn_rate[size_t(grid.right_node(i))]);
        length += segment;
    }
    return burnt / length;
}

}  // namespace crawford
