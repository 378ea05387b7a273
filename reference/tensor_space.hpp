/// Piecewise polynomials on a graded rectangle.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "reference/lobatto.hpp"

namespace crawford::reference {

/// Break points from `from` to `to`, ever closer to `to`: the distances left are |to - from|
/// ratio^k, k = 0..layers, and 0. A geometric mesh of this kind resolves a corner singularity
/// exponentially fast in the polynomial degree.
std::vector<double> graded(double from, double to, int layers, double ratio);

/// Continuous piecewise polynomials of one degree in x and y on a mesh of rectangles (a tensor
/// product).
///
/// Nodes form a lattice of columns and rows; node = row * columns + column. Within an element the
/// local node is j * (degree + 1) + i, with i along x and j along y.
class TensorSpace {
public:
    /// Break points x and y [m], strictly ascending.
    /// \throws std::invalid_argument if they are not.
    TensorSpace(std::vector<double> x, std::vector<double> y, int degree);

    const LobattoBasis& basis() const { return basis_; }
    int columns() const { return elements_x() * basis_.degree() + 1; }
    int rows() const { return elements_y() * basis_.degree() + 1; }
    int nodes() const { return columns() * rows(); }
    int elements_x() const { return static_cast<int>(x_.size()) - 1; }
    int elements_y() const { return static_cast<int>(y_.size()) - 1; }
    int elements() const { return elements_x() * elements_y(); }

    int node(int column, int row) const { return row * columns() + column; }

    /// One rectangle: its corner, sides [m], centre abscissa, and the global nodes in local order.
    struct Element {
        double left, bottom, width, height;
        std::vector<int> nodes;
        double middle() const { return left + width / 2.0; }
    };
    Element element(int index) const;
    /// The element that covers a share of the surface, the topmost row, at position `column` from
    /// the left.
    int top_element(int column) const { return (elements_y() - 1) * elements_x() + column; }

    /// Where a point lies: its element, and there the shape functions and their derivatives [1/m]
    /// by local node.
    struct Probe {
        int element;
        std::vector<int> nodes;
        Eigen::VectorXd value, dx, dy;
    };
    /// A point on an edge between elements is given to the left and to the lower one.
    /// \throws std::invalid_argument outside the mesh.
    Probe at(double x, double y) const;

private:
    std::vector<double> x_, y_;
    LobattoBasis basis_;
};

}  // namespace crawford::reference
