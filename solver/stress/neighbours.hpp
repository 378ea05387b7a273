/// Which values a stress stencil may read, along the rows and the columns of the grid.
#pragma once

#include <array>

#include "solver/materials/material_map.hpp"
#include "solver/stress/upwind.hpp"

namespace crawford {

/// The five cells of a stencil, and which of them it may read. A neighbour is closed where it lies
/// beyond the grid or in another material, or behind a closed one. All that a cell carries, at each
/// of its points, reads the same cells.
struct Reach {
    struct Place {
        int i, j;
        bool open, mirrored;
        double share;  ///< of the deviator there that the middle cell can carry
    };
    std::array<Place, 5> places;

    const Place& at(int offset) const { return places[size_t(2 + offset)]; }
};

/// Finds the cells and reads them.
///
/// A stress that is carried into a softer cell keeps its elastic strain and not its size: a cell
/// that an interface cuts is softer than its neighbour of the same class, and could relax what it
/// cannot carry only by a huge strain.
class StressNeighbours {
public:
    StressNeighbours(const Grid& grid, const MaterialMap& materials)
        : grid_(grid), materials_(materials) {}

    Reach along_row(int i, int j) const;
    Reach along_column(int i, int j) const;

private:
    Reach::Place beside(int i, int j, int offset) const;
    Reach::Place above(int i, int j, int offset) const;

    template <class Find>
    Reach reach(int i, int j, const Find& find) const;

    const Grid& grid_;
    const MaterialMap& materials_;
};

/// The deviator at a point of a cell, as the middle cell of the stencil can carry it.
inline Deviator read(const StressField& stress, int point, const Reach::Place& at) {
    // Points come in pairs beside each other: across a plane of symmetry each meets its partner.
    const int source = at.mirrored && stress.points() > 1 ? point ^ 1 : point;
    Deviator s = stress.deviator[size_t(source)](at.i, at.j);
    if (at.mirrored) s.s12 = -s.s12;
    return at.share * s;
}

/// Undivided upwind derivative along the stencil for a flow of the sign of `velocity`.
inline Deviator upwind_derivative(const StressField& stress, int point, const Reach& reach,
                                  double velocity) {
    return upwind_derivative<Deviator>(
        velocity, [&](int k) { return reach.at(k).open; },
        [&](int k) { return read(stress, point, reach.at(k)); });
}
inline double upwind_derivative(const CellField& pressure, const Reach& reach, double velocity) {
    return upwind_derivative<double>(
        velocity, [&](int k) { return reach.at(k).open; },
        [&](int k) { return pressure(reach.at(k).i, reach.at(k).j); });
}

}  // namespace crawford
