#include "cases/catalogue/pack_maps.hpp"

#include <algorithm>

#include "cases/catalogue/units.hpp"

namespace crawford {

namespace {

using namespace units;

/// The lowest row of cells that a map shows: the first whose upper side reaches above `bottom`.
int first_row(const Snapshot& snapshot, double bottom) {
    const auto& at = snapshot.position;
    int j = 0;
    const auto below = [&](int row) {
        for (int i = 0; i < at.columns(); ++i)
            if (at(i, row).y() > bottom) return false;
        return true;
    };
    while (j + 2 < at.rows() && below(j + 1)) ++j;
    return j;
}

reports::QuadMap corners(const Snapshot& snapshot, int first) {
    const auto& at = snapshot.position;
    reports::QuadMap map{.columns = size_t(at.columns() - 1),
                         .rows = size_t(at.rows() - 1 - first),
                         .x = {"x", "um", {}},
                         .y = {"y", "um", {}},
                         .fields = {}};
    for (int j = first; j < at.rows(); ++j)
        for (int i = 0; i < at.columns(); ++i) {
            map.x.values.push_back(at(i, j).x() / um);
            map.y.values.push_back(at(i, j).y() / um);
        }
    return map;
}

/// By rows, as a map wants them.
std::vector<double> values(const Lattice<double>& field, int first, double scale) {
    std::vector<double> result;
    for (int j = first; j < field.rows(); ++j)
        for (int i = 0; i < field.columns(); ++i) result.push_back(field(i, j) / scale);
    return result;
}

/// Mean of the cells about each node, also across the periodic sides.
NodeField at_nodes(const CellField& cells) {
    const int n = cells.columns();
    NodeField nodes(n + 1, cells.rows() + 1, 0.0);
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= cells.rows(); ++j) {
            const int left = (i + n - 1) % n, right = i % n;
            const int below = std::max(j - 1, 0), above = std::min(j, cells.rows() - 1);
            nodes(i, j) = 0.25 * (cells(left, below) + cells(right, below) + cells(left, above) +
                                  cells(right, above));
        }
    return nodes;
}

}  // namespace

SurfaceSpan surface_span(const Snapshot& snapshot) {
    const auto& at = snapshot.position;
    const int top = at.rows() - 1;
    SurfaceSpan span{at(0, top).y(), at(0, top).y()};
    for (int i = 0; i < at.columns(); ++i) {
        span.lowest = std::min(span.lowest, at(i, top).y());
        span.highest = std::max(span.highest, at(i, top).y());
    }
    return span;
}

reports::QuadMap node_maps(const Snapshot& snapshot, double bottom) {
    const int first = first_row(snapshot, bottom);
    reports::QuadMap map = corners(snapshot, first);
    map.fields = {{"T", "K", values(snapshot.temperature, first, 1.0)},
                  {"fraction of AP", "-", values(at_nodes(snapshot.material), first, 1.0)}};
    return map;
}

reports::QuadMap cell_maps(const Snapshot& snapshot, double bottom) {
    const int first = first_row(snapshot, bottom);
    reports::QuadMap map = corners(snapshot, first);
    map.fields = {{"p", "MPa", values(snapshot.pressure, first, MPa)},
                  {"strain norm", "-", values(snapshot.strain_norm, first, 1.0)}};
    return map;
}

}  // namespace crawford
