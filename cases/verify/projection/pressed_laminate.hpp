/// Layers along y, pressed at their ends in one step of the projection, against the exact laminate.
#pragma once

#include <vector>

#include "cases/units.hpp"
#include "reference/elastic_laminate.hpp"
#include "solver/scene/scene.hpp"

namespace crawford::pressed_laminate {

inline constexpr double pressure = 2.0 * units::MPa;
inline constexpr double width = 240.0 * units::um;  ///< period
inline constexpr double depth = 240.0 * units::um;

/// A strip in AP, strained along the layers.
reference::LaminateConditions laminate(const reference::Material& inner, double strip,
                                       double axial_strain);

/// Layers that carry the same sigma_yy, strained as the pressure wants it: the strip is softer in
/// shear and stiffer in bulk than the AP beside it.
reference::LaminateConditions matched(double strip);

/// Half of it, as many cells across the whole period as up.
Scene scene(const reference::LaminateConditions& laminate, int nx, double clustering);

/// One step, and what it should have found: displacements at nodes, stresses of cells.
struct Run {
    double axial_strain;  ///< of the lowest row of cells, where nothing is felt of the end
    std::vector<double> u, v, xx, yy;
    std::vector<double> u_exact, v_exact, xx_exact, yy_exact;

    Run(const reference::LaminateConditions& laminate, const Scene& scene);
};

}  // namespace crawford::pressed_laminate
