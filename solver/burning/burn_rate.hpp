/// How fast the surface burns and what heat enters through it   (paper eq. 8, 11).
#pragma once

#include <utility>

#include "solver/materials/material_map.hpp"

namespace crawford {

/// A heat flux about a temperature: value + slope (T - temperature).
struct LinearFlux {
    double value;  ///< [W/m^2]
    double slope;  ///< [W/(m^2 K)], not above zero where pyrolysis absorbs heat
};

class BurningLaw {
public:
    BurningLaw(Regression regression, Surface surface)
        : regression_(regression), surface_(std::move(surface)) {}

    /// r_b [m/s] of a surface made of `fraction` of the first material, at a temperature [K].
    double burn_rate(const MaterialMap& materials, double fraction, double temperature) const;

    /// Q_g + q_s rho r_b into the same surface, per unit true area, linearised about `temperature`.
    LinearFlux heat_flux(const MaterialMap& materials, double fraction, double temperature) const;

    /// r_b [m/s] of each node column; where the two cells beside a node differ, it burns as their
    /// mean. `temperature` may be empty where the rate does not depend on it.
    SurfaceField burn_rate(const Grid& grid, const MaterialMap& materials,
                           const NodeField& temperature) const;

private:
    double material_rate(const Material& material, double temperature) const;
    double material_rate_slope(const Material& material, double temperature) const;

    Regression regression_;
    Surface surface_;
};

/// Surface average of r_b over the true length: integral of r_b ds over integral of ds.
double mean_burn_rate(const Grid& grid, const SurfaceField& surface, const SurfaceField& burn_rate);

}  // namespace crawford
