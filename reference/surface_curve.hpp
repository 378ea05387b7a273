/// A surface given by its slope, piece by piece.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "reference/lobatto.hpp"

namespace crawford::reference {

/// A surface y = phi(x) given by its slope, a polynomial on each of a row of pieces, with jumps
/// between them where it has kinks. phi = 0 at the right end.
class SurfaceCurve {
public:
    /// \param ends of the pieces [m], ascending
    /// \param slopes of each piece at the points of the basis, pieces x points
    SurfaceCurve(std::vector<double> ends, const LobattoBasis& basis, Eigen::MatrixXd slopes);

    double slope(double x) const;   ///< at x [m] from end to end; between two pieces, of the left
    double height(double x) const;  ///< phi [m]
    double length(double from, double to) const;  ///< of the arc between two ends of pieces [m]

private:
    std::size_t piece(double x) const;
    double slope_on(std::size_t piece, double x) const;
    template <class Function>
    double integral(double from, double to, const Function& f) const;

    std::vector<double> ends_;
    LobattoBasis basis_;
    GaussRule rule_;
    Eigen::MatrixXd slopes_;
    std::vector<double> heights_;  // at the ends [m]
};

}  // namespace crawford::reference
