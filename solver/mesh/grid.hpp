/// The surface-following, clustered grid in the coordinates (x, eta), eta = y - phi(x, t)   (paper
/// eq. 31, 32; Fig. 1).
///
/// Nodes carry temperature, velocity and reference map; cells carry stress and strain. Between two
/// node columns the surface is straight, so every cell is a parallelogram with two vertical sides.
#pragma once

#include <vector>

#include "solver/mesh/columns.hpp"
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
    /// \param interface half the width of the strip that columns cluster about [m]; \see columns_of
    explicit Grid(const Domain& domain, double interface = 0.0);

    int cell_columns() const { return cell_columns_; }
    int node_columns() const { return sides_ == Sides::mirror ? cell_columns_ + 1 : cell_columns_; }
    /// Of cells; there is one row of nodes more, j = 0 at the bottom.
    int rows() const { return rows_; }
    Sides sides() const { return sides_; }
    double width() const { return width_; }            ///< of what is modelled [m]
    double depth() const { return depth_; }            ///< [m]
    double dx(int i) const { return dx_[size_t(i)]; }  ///< of cell column i [m]
    /// Mean width of a column [m]: that of all where they are even.
    double dx() const { return mean_dx_; }

    /// Of node column i [m]; x = 0 is the axis of a sandwich.
    double x(int i) const { return columns_.x[size_t(i)]; }
    double eta(int j) const { return eta_[size_t(j)]; }  ///< of node row j [m], 0 at the surface
    double height(int j) const { return eta(j + 1) - eta(j); }  ///< of cell row j [m]

    /// d(eta)/dj at node row j [m]: the exact metric of paper eq. 32, for differences along
    /// a column.
    double metric(int j) const { return metric_[size_t(j)]; }

    /// dx/di at node column i [m], for differences along a row, and at a part `a` of the way from
    /// there to the next.
    double metric_x(int i) const { return columns_.metric[size_t(i)]; }
    double metric_x(int i, double a) const {
        return metric_x(i) + a * (columns_.metric[size_t(i) + 1] - metric_x(i));
    }

    /// The node column on the right of cell column i; on its left is node column i.
    int right_node(int i) const {
        return sides_ == Sides::periodic && i + 1 == cell_columns_ ? 0 : i + 1;
    }

    /// The column that stands for column i, which may lie beyond the sides.
    NodeColumn node_column(int i) const;

    /// Slope of the straight surface over cell column i, from the heights at the node columns.
    double slope(const SurfaceField& surface, int i) const {
        return (surface[size_t(right_node(i))] - surface[size_t(i)]) / dx(i);
    }

private:
    Sides sides_;
    int cell_columns_;
    int rows_;
    double mean_dx_;
    double width_;
    Columns columns_;
    std::vector<double> dx_;
    double depth_;
    std::vector<double> eta_;
    std::vector<double> metric_;
};

/// Of the straight surface between the node columns, over the width [m].
double mean_height(const Grid& grid, const SurfaceField& surface);
/// Of its segments, in magnitude.
double largest_slope(const Grid& grid, const SurfaceField& surface);

double narrowest_column(const Grid& grid);  ///< [m]
double lowest_row(const Grid& grid);        ///< [m]

}  // namespace crawford
