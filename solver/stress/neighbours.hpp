/// Which values a stress stencil may read, along the rows and the columns of the grid.
#pragma once

#include "solver/materials/material_map.hpp"
#include "solver/stress/upwind.hpp"

namespace crawford {

/// Gathers the neighbourhoods of one lattice of a StressField.
///
/// A stress that is carried into a softer cell keeps its elastic strain and not its size: a cell
/// that an interface cuts is softer than its neighbour of the same class, and could relax what it
/// cannot carry only by a huge strain.
class StressNeighbours {
public:
    StressNeighbours(const Grid& grid, const MaterialMap& materials)
        : grid_(grid), materials_(materials) {}

    Neighbourhood<Deviator> along_row(const StressField& stress, int point, int i, int j) const;
    Neighbourhood<double> along_row(const CellField& pressure, int i, int j) const;
    Neighbourhood<Deviator> along_column(const StressField& stress, int point, int i, int j) const;
    Neighbourhood<double> along_column(const CellField& pressure, int i, int j) const;

private:
    struct Place {
        int i, j;
        bool exists, mirrored;
    };

    Place beside(int i, int j, int offset) const;
    Place above(int i, int j, int offset) const;

    template <class Value, class Find, class Read>
    Neighbourhood<Value> gather(int i, int j, const Find& find, const Read& read) const;
    Deviator read(const StressField& stress, int point, int i, int j, const Place& at) const;

    const Grid& grid_;
    const MaterialMap& materials_;
};

}  // namespace crawford
