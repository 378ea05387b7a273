#include "reference/elastic_sandwich.hpp"

#include <cmath>

#include "reference/condensed_system.hpp"
#include "reference/require.hpp"

namespace crawford::reference {
namespace {

/// Integral of (C:D(w)):D(u) over a rectangle, from one-dimensional integrals.
Eigen::MatrixXd stiffness(const LobattoBasis& basis, const TensorSpace::Element& element,
                          const Material& material) {
    const auto& mass = basis.mass();
    const auto& bend = basis.stiffness();
    const auto& turn = basis.convection();
    const double across = element.height / element.width;
    const double lambda = material.lame();
    const double mu = material.shear_modulus;
    const double p_wave = material.uniaxial_modulus();
    const int n = basis.degree() + 1;
    Eigen::MatrixXd k(2 * n * n, 2 * n * n);
    for (int a = 0; a < n * n; ++a) {
        for (int b = 0; b < n * n; ++b) {
            const int i = a % n, j = a / n, m = b % n, l = b / n;
            const double xx = across * bend(i, m) * mass(j, l);
            const double yy = mass(i, m) * bend(j, l) / across;
            const double xy = turn(m, i) * turn(j, l);  // d/dx of a times d/dy of b
            const double yx = turn(i, m) * turn(l, j);
            k(2 * a, 2 * b) = p_wave * xx + mu * yy;
            k(2 * a, 2 * b + 1) = lambda * xy + mu * yx;
            k(2 * a + 1, 2 * b) = lambda * yx + mu * xy;
            k(2 * a + 1, 2 * b + 1) = p_wave * yy + mu * xx;
        }
    }
    return k;
}

/// Nodal forces of a downward pressure on the top edge of an element.
Eigen::VectorXd load(const LobattoBasis& basis, const TensorSpace::Element& element,
                     double pressure) {
    const int n = basis.degree() + 1;
    Eigen::VectorXd force = Eigen::VectorXd::Zero(2 * n * n);
    for (int i = 0; i < n; ++i) {
        const int top = (n - 1) * n + i;
        force[2 * top + 1] = -pressure * basis.mass().row(i).sum() * element.width / 2.0;
    }
    return force;
}

void require_elastic(const Material& material) {
    require_positive("bulk_modulus", material.bulk_modulus);
    require_positive("shear_modulus", material.shear_modulus);
}

}  // namespace

ElasticSandwich::ElasticSandwich(const SandwichGeometry& geometry, double pressure, Support support,
                                 const SandwichElements& elements)
    : geometry_(geometry), space_(sandwich_space(geometry, elements)) {
    require_elastic(geometry.inner);
    require_elastic(geometry.outer);
    require_finite("pressure", pressure);
    assemble_and_solve(pressure, support);
}

void ElasticSandwich::assemble_and_solve(double pressure, Support support) {
    CondensedSystem system(space_, 2);
    for (int e = 0; e < space_.elements(); ++e) {
        const auto element = space_.element(e);
        const bool at_surface = e >= space_.top_element(0);
        system.add(e, stiffness(space_.basis(), element, material_of(geometry_, element)),
                   load(space_.basis(), element, at_surface ? pressure : 0.0));
    }
    for (int row = 0; row < space_.rows(); ++row) {
        system.hold(space_.node(0, row), 0, 0.0);
        system.hold(space_.node(space_.columns() - 1, row), 0, 0.0);
    }
    for (int column = 0; column < space_.columns(); ++column) {
        system.hold(space_.node(column, 0), 1, 0.0);
        if (support == Support::clamped) system.hold(space_.node(column, 0), 0, 0.0);
    }
    displacement_ = system.solve();
}

Eigen::Vector2d ElasticSandwich::displacement(double x, double y) const {
    const auto probe = space_.at(std::abs(x), y);
    Eigen::Vector2d result = Eigen::Vector2d::Zero();
    for (std::size_t a = 0; a < probe.nodes.size(); ++a) {
        result += probe.value[static_cast<Eigen::Index>(a)] *
                  displacement_.segment<2>(2 * probe.nodes[a]);
    }
    if (x < 0.0) result[0] = -result[0];
    return result;
}

PlaneStrainStress ElasticSandwich::stress(double x, double y) const {
    const auto probe = space_.at(std::abs(x), y);
    Eigen::Vector2d along_x = Eigen::Vector2d::Zero();
    Eigen::Vector2d along_y = Eigen::Vector2d::Zero();
    for (std::size_t a = 0; a < probe.nodes.size(); ++a) {
        const auto node = displacement_.segment<2>(2 * probe.nodes[a]);
        along_x += probe.dx[static_cast<Eigen::Index>(a)] * node;
        along_y += probe.dy[static_cast<Eigen::Index>(a)] * node;
    }
    const Material& material = material_of(geometry_, space_.element(probe.element));
    const double mu = material.shear_modulus;
    const double volumetric = material.lame() * (along_x[0] + along_y[1]);
    const double shear = mu * (along_y[0] + along_x[1]);
    return {.xx = volumetric + 2.0 * mu * along_x[0],
            .yy = volumetric + 2.0 * mu * along_y[1],
            .zz = volumetric,
            .xy = x < 0.0 ? -shear : shear};
}

}  // namespace crawford::reference
