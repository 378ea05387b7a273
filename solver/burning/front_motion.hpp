/// The burning front: what each node of the surface burns at, and how fast it falls   (paper eq. 8,
/// 9, 33).
#pragma once

#include <memory>

#include "solver/burning/burn_rate.hpp"

namespace crawford {

/// The surface as it stands: heights [m], temperature of the solid [K] (empty where the rate does
/// not depend on it), and the material velocity of the surface nodes [m/s] where the surface is
/// carried along, empty where it is not.
struct BurningSurface {
    const SurfaceField& height;
    const NodeField& temperature;
    const std::vector<Vector>& material_velocity;
};

class FrontMotion {
public:
    virtual ~FrontMotion() = default;

    /// r_b of each node column [m/s].
    virtual SurfaceField burn_rate(const NodeField& temperature) const = 0;
    /// phi_t of each node column [m/s], for a step of dt [s].
    virtual SurfaceField rate(const BurningSurface& surface, double dt) const = 0;
    /// Surface average of r_b over the true length [m/s]: integral of r_b ds over integral of ds.
    virtual double mean_burn_rate(const SurfaceField& height,
                                  const NodeField& temperature) const = 0;
};

/// The motion that a scene asks for. Grid, materials and law must outlive it.
std::unique_ptr<FrontMotion> front_motion(Front front, const Grid& grid,
                                          const MaterialMap& materials, const BurningLaw& law);

}  // namespace crawford
