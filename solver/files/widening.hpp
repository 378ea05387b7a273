/// Pictures in the shape that was asked for, of a run that computed a part of the columns.
#pragma once

#include "solver/files/snapshot.hpp"

namespace crawford {

class Widening {
public:
    /// All columns were computed.
    Widening() = default;

    /// One column of cells about x = 0 was, and each of `columns`, `width` [m] in all, is like it.
    static Widening of_one_column(int columns, double width);

    /// The right half of `columns` was, x >= 0; the other is its mirror image.
    static Widening of_right_half(int columns);

    /// Of node fields with the column on the right side.
    NodeVectors places(const NodeVectors& part) const;
    NodeVectors vectors(const NodeVectors& part) const;
    NodeField nodes(const NodeField& part) const;

    CellField cells(const CellField& part) const;

    Snapshot whole(Snapshot part) const;

private:
    /// Where a column of the whole is taken from.
    struct Source {
        int column;
        bool mirrored;
    };

    Widening(int columns, double width, bool by_mirror)
        : columns_(columns), width_(width), by_mirror_(by_mirror) {}

    Source node(int i) const;
    Source cell(int i) const;

    template <class Value, class Take>
    Lattice<Value> widened(const Lattice<Value>& part, int columns, Take take) const;

    int columns_ = 0;     ///< of cells in the whole; 0: nothing to widen
    double width_ = 0.0;  ///< of the whole [m]
    bool by_mirror_ = false;
};

}  // namespace crawford
