#include "solver/element/element.hpp"

#include <cmath>
#include <stdexcept>

namespace crawford {

namespace {

using Matrix4 = Eigen::Matrix4d;

/// Integrals over the unit square of products of derivatives of the hats:
/// d_a d_a, d_a d_b, d_b d_b.
struct Moments {
    Matrix4 aa, ab, bb;
};

Moments reference_moments() {
    const Eigen::Matrix2d stiff = (Eigen::Matrix2d() << 1, -1, -1, 1).finished();
    const Eigen::Matrix2d mass = (Eigen::Matrix2d() << 2, 1, 1, 2).finished() / 6.0;
    // integral of N_p' N_q in one direction: row p differentiated, column q not.
    const Eigen::Matrix2d mixed = (Eigen::Matrix2d() << -1, -1, 1, 1).finished() / 2.0;
    Moments m;
    for (int p = 0; p < 4; ++p)
        for (int q = 0; q < 4; ++q) {
            m.aa(p, q) = stiff(p % 2, q % 2) * mass(p / 2, q / 2);
            m.bb(p, q) = mass(p % 2, q % 2) * stiff(p / 2, q / 2);
            m.ab(p, q) = mixed(p % 2, q % 2) * mixed(q / 2, p / 2);
        }
    return m;
}

/// Integrals over the cell of products of the hats' derivatives in x and y.
struct GradientMoments {
    Matrix4 xx, xy, yy;

    explicit GradientMoments(const Cell& cell) {
        static const Moments unit = reference_moments();
        const double along = 1.0 / cell.dx;            // d/dx = along d_a - tilt d_b
        const double tilt = cell.slope / cell.height;  // d/dy = up d_b
        const double up = 1.0 / cell.height;
        const double area = cell.area();
        xx = area * (along * along * unit.aa - along * tilt * (unit.ab + unit.ab.transpose()) +
                     tilt * tilt * unit.bb);
        xy = area * up * (along * unit.ab - tilt * unit.bb);
        yy = area * up * up * unit.bb;
    }
};

ElementMatrix fully_integrated(const GradientMoments& g, double lame, double shear) {
    const double stretch = lame + 2.0 * shear;
    ElementMatrix k;
    for (int p = 0; p < 4; ++p)
        for (int q = 0; q < 4; ++q) {
            k(2 * p, 2 * q) = stretch * g.xx(p, q) + shear * g.yy(p, q);
            k(2 * p + 1, 2 * q + 1) = stretch * g.yy(p, q) + shear * g.xx(p, q);
            k(2 * p, 2 * q + 1) = lame * g.xy(p, q) + shear * g.xy(q, p);
            k(2 * p + 1, 2 * q) = lame * g.xy(q, p) + shear * g.xy(p, q);
        }
    return k;
}

/// Mean over the cell of the divergence of each of the eight shape vectors; the mean gradient is
/// that at the centre.
Eigen::Matrix<double, 8, 1> mean_divergence(const Cell& cell) {
    const auto hats = hat_gradients(cell, cell_centre);
    Eigen::Matrix<double, 8, 1> d;
    for (int p = 0; p < 4; ++p) d.segment<2>(2 * p) = hats[size_t(p)];
    return d;
}

}  // namespace

const std::vector<Local>& stress_points(Element element) {
    static const double low = 0.5 - 0.5 / std::sqrt(3.0);
    static const double high = 1.0 - low;
    static const std::vector<Local> gauss{{low, low}, {high, low}, {low, high}, {high, high}};
    static const std::vector<Local> centre{cell_centre};
    return element == Element::bbar ? gauss : centre;
}

ElementMatrix stiffness(Element element, const Cell& cell, const Moduli& moduli) {
    const GradientMoments g(cell);
    const double deviatoric_lame = -2.0 / 3.0 * moduli.shear;
    if (element == Element::q1)
        return fully_integrated(g, moduli.bulk + deviatoric_lame, moduli.shear);
    const auto d = mean_divergence(cell);
    return fully_integrated(g, deviatoric_lame, moduli.shear) +
           moduli.bulk * cell.area() * d * d.transpose();
}

}  // namespace crawford
