/// Fields of a pack as maps for figures.
#pragma once

#include "reports/figure_data.hpp"
#include "solver/output/snapshot.hpp"

namespace crawford {

/// Lowest and highest point of the surface [m].
struct SurfaceSpan {
    double lowest, highest;
};
SurfaceSpan surface_span(const Snapshot& snapshot);

/// Temperature and fraction of AP at the nodes (the mean of the cells about each: its contour at
/// one half is the outline of the discs); lengths in um. Rows that lie below `bottom` [m] are left
/// out.
reports::QuadMap node_maps(const Snapshot& snapshot, double bottom);
/// Pressure in MPa and strain norm of the cells, likewise.
reports::QuadMap cell_maps(const Snapshot& snapshot, double bottom);

}  // namespace crawford
