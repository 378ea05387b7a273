/// Fields of a pack as maps for figures.
#pragma once

#include <vector>

#include "reports/figure_data.hpp"
#include "solver/files/snapshot.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

/// Lowest and highest point of the surface [m].
struct SurfaceSpan {
    double lowest, highest;
};
SurfaceSpan surface_span(const Snapshot& snapshot);

/// Temperature of the nodes; lengths in um. Rows that lie below `bottom` [m] are left out.
reports::QuadMap node_maps(const Snapshot& snapshot, double bottom);
/// Pressure in MPa, strain norm and fraction of AP of the cells, likewise.
reports::QuadMap cell_maps(const Snapshot& snapshot, double bottom);

/// x and y of the surface [um].
std::vector<reports::Column> surface_line_of(const Snapshot& snapshot);
/// What is left of the rims of the discs between `bottom` [m] and the surface, as a line of x and y
/// [um] with a NaN wherever the pen is lifted. They are those of the scene, in the laboratory,
/// where the solver's cells have fractions.
std::vector<reports::Column> disc_rims(const Scene& scene, const Snapshot& snapshot, double bottom);

}  // namespace crawford
