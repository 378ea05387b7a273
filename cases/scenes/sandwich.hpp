/// The AP/binder sandwich of cases/scenes/sandwich.toml.
#pragma once

#include <string>
#include <vector>

#include "cases/kept_burn.hpp"
#include "cases/registry.hpp"
#include "cases/scene_text.hpp"
#include "reports/figure_data.hpp"

namespace crawford {

/// The scene of cases/scenes/sandwich.toml with other values for some keys ("dotted.key=value"). It
/// goes on to time.end even if it is steady before, so that all grids of a study stop together.
Scene sandwich(const std::vector<std::string>& overrides);

/// The burning sandwich at a fidelity: paper is 64 columns over the whole width, 96 rows, steps of
/// 20 us, until 0.1 s.
Scene burning_sandwich(Fidelity fidelity, bool mechanics);

/// A line along the surface: x from side to side of the whole sandwich [m], height and temperature
/// of the surface [m, K].
struct SurfaceLine {
    std::vector<double> x, height, temperature;
};
SurfaceLine surface_line(const Snapshot& half);

/// A field of a half sandwich, at its nodes or cells, mirrored to the whole; lengths in um, values
/// divided by `scale`.
reports::QuadMap whole_map(const Snapshot& half, const std::string& name, const std::string& unit,
                           const Lattice<double>& field, double scale);

}  // namespace crawford
