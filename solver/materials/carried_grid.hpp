/// Where the cells of the grid came from.
#pragma once

#include <array>
#include <utility>

#include "solver/materials/surface_pieces.hpp"
#include "solver/mesh/grid.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

/// The grid below a surface, each node taken back to where its material started: xi = (x, y) +
/// shift. A cell is bilinear, and the image of its straight edges is straight.
class CarriedGrid {
public:
    /// \param shift xi - (x, y) [m] of each node; null where nothing has moved. Both fields must
    /// outlive this view.
    /// \throws NumericalFailure naming a cell that the map turns inside out.
    CarriedGrid(const Grid& grid, const SurfaceField& surface, const NodeVectors* shift);

    /// The corners of cell (i, j), anticlockwise from the lower left, as seen from `origin` [m].
    std::array<Vector, 4> cell(int i, int j, const Vector& origin) const;
    double area(int i, int j) const;  ///< [m^2]
    /// The surface over cell column i, from left to right, seen likewise.
    Segment top(int i, const Vector& origin) const;

    Vector lowest() const;   ///< of what the coordinates of a node can be [m]
    Vector highest() const;  ///< [m]

    /// First and one past the last of the columns that may reach into left <= xi_1 <= right.
    std::pair<int, int> columns(double left, double right) const;
    /// Likewise of the rows of column i, for low <= xi_2 <= high.
    std::pair<int, int> rows(int i, double low, double high) const;

private:
    Vector shift(int i, int j) const { return shift_ ? (*shift_)(i, j) : Vector::Zero(); }

    const Grid& grid_;
    const SurfaceField& surface_;
    const NodeVectors* shift_;
    Vector least_ = Vector::Zero();  ///< of the shifts, by component
    Vector most_ = Vector::Zero();
};

}  // namespace crawford
