/// The surface-following, clustered grid in the coordinates (x, eta), eta = y - phi(x, t)   (paper
/// eq. 31, 32; Fig. 1).
///
/// Nodes carry temperature, velocity and reference map; cells carry stress and strain. Between two
/// node columns the surface is straight, so every cell is a parallelogram with two vertical sides.
#pragma once

#include <vector>

#include "solver/mesh/lattice.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

/// What happens at the left and right side of the window.
enum class Sides {
    periodic,  ///< node column nx is node column 0
    mirror     ///< both sides are planes of symmetry; there are nx + 1 node columns
};

/// A node column seen from beyond the sides.
struct NodeColumn {
    int index;
    bool mirrored;  ///< what is odd in x changes its sign
};

class Grid {
public:
    explicit Grid(const Domain& domain);

    int cell_columns() const { return cell_columns_; }
    int node_columns() const { return sides_ == Sides::mirror ? cell_columns_ + 1 : cell_columns_; }
    /// Of cells; there is one row of nodes more, j = 0 at the bottom.
    int rows() const { return rows_; }
    Sides sides() const { return sides_; }
    double width() const { return dx_ * cell_columns_; }  ///< of what is modelled [m]
    double depth() const { return depth_; }               ///< [m]
    double dx() const { return dx_; }                     ///< [m]

    /// Of node column i [m]; x = 0 is the axis of a sandwich.
    double x(int i) const { return left_ + dx_ * i; }
    double eta(int j) const { return eta_[size_t(j)]; }  ///< of node row j [m], 0 at the surface
    double height(int j) const { return eta(j + 1) - eta(j); }  ///< of cell row j [m]

    /// d(eta)/dj at node row j [m]: the exact metric of paper eq. 32, for differences along
    /// a column.
    double metric(int j) const { return metric_[size_t(j)]; }

    /// The node column on the right of cell column i; on its left is node column i.
    int right_node(int i) const {
        return sides_ == Sides::periodic && i + 1 == cell_columns_ ? 0 : i + 1;
    }

    /// The column that stands for column i, which may lie beyond the sides.
    NodeColumn node_column(int i) const;

    /// Slope of the straight surface over cell column i, from the heights at the node columns.
    double slope(const SurfaceField& surface, int i) const {
        return (surface[size_t(right_node(i))] - surface[size_t(i)]) / dx_;
    }

private:
    Sides sides_;
    int cell_columns_;
    int rows_;
    double dx_;
    double left_;
    double depth_;
    std::vector<double> eta_;
    std::vector<double> metric_;
};

/// Of the straight surface between the node columns, over the width [m].
double mean_height(const Grid& grid, const SurfaceField& surface);

}  // namespace crawford
