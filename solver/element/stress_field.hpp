/// The Cauchy stress where the element carries it:
/// a deviator at each integration point, one pressure a cell.
///
/// sigma = s - p I with tr s = 0, so that s33 = -(s11 + s22). A cell of the B-bar element has 2 x 2
/// Gauss points, a cell of the paper's q1 element one, its centre, where (s, p) is the paper's
/// (sigma11, sigma22, sigma33, tau).
#pragma once

#include <array>

#include "solver/mesh/lattice.hpp"

namespace crawford {

/// The in-plane components s11, s22, s12 of a deviator [Pa]; s33 = -(s11 + s22).
struct Deviator {
    double s11 = 0.0, s22 = 0.0, s12 = 0.0;

    friend Deviator operator+(const Deviator& s, const Deviator& t) {
        return {s.s11 + t.s11, s.s22 + t.s22, s.s12 + t.s12};
    }
    friend Deviator operator-(const Deviator& s, const Deviator& t) {
        return {s.s11 - t.s11, s.s22 - t.s22, s.s12 - t.s12};
    }
    friend Deviator operator*(double c, const Deviator& s) {
        return {c * s.s11, c * s.s22, c * s.s12};
    }
};

/// The components of a full plane-strain stress [Pa].
struct PlaneStress {
    double s11 = 0.0, s22 = 0.0, s33 = 0.0, s12 = 0.0;
};

struct StressField {
    std::vector<Lattice<Deviator>> deviator;  ///< one lattice of cells for each point of a cell
    CellField pressure;                       ///< -tr(sigma)/3 [Pa]

    StressField() = default;
    StressField(int columns, int rows, int points)
        : deviator(size_t(points), Lattice<Deviator>(columns, rows)), pressure(columns, rows) {}

    int points() const { return int(deviator.size()); }
    bool empty() const { return deviator.empty(); }

    /// The stress of cell (i, j), averaged over its points.
    PlaneStress mean(int i, int j) const;
};

}  // namespace crawford
