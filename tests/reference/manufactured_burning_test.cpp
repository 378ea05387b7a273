#include "reference/manufactured_burning.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace crawford::reference {
namespace {

// The sources are checked by differences of the solution's values alone: central, and one step of
// Richardson's extrapolation, so that truncation is O(h^4) and round-off some 1e-9 of the field.

BurningParameters parameters() {
    Material material = ap();
    material.bulk_modulus = 5e9;
    material.shear_modulus = 1e9;
    material.thermal_expansion = 1.5e-4;
    return {.material = material,
            .width = 240e-6,
            .depth = 200e-6,
            .regression_rate = 0.0045,
            .wave_height = 6e-6,
            .wave_frequency = 300.0,
            .bottom_temperature = 300.0,
            .displacement = 4e-6,
            .motion_frequency = 800.0,
            .stress = 2e8,
            .gas_pressure = 2e6,
            .gas_flux = 8e6};
}

using Field = std::function<double(double, double, double)>;

constexpr double dx = 2e-6;
constexpr double dt = 1e-5;

template <class F>
double slope(const F& f, double h) {
    const auto central = [&](double d) { return (f(d) - f(-d)) / (2.0 * d); };
    return (4.0 * central(0.5 * h) - central(h)) / 3.0;
}
template <class F>
double curvature(const F& f, double h) {
    const auto central = [&](double d) { return (f(d) - 2.0 * f(0.0) + f(-d)) / (d * d); };
    return (4.0 * central(0.5 * h) - central(h)) / 3.0;
}

struct Point {
    double x, y, t;

    double d_x(const Field& f) const {
        return slope([&](double d) { return f(x + d, y, t); }, dx);
    }
    double d_y(const Field& f) const {
        return slope([&](double d) { return f(x, y + d, t); }, dx);
    }
    double d_t(const Field& f) const {
        return slope([&](double d) { return f(x, y, t + d); }, dt);
    }
    double laplacian(const Field& f) const {
        return curvature([&](double d) { return f(x + d, y, t); }, dx) +
               curvature([&](double d) { return f(x, y + d, t); }, dx);
    }
};

class Burning : public testing::Test {
protected:
    const ManufacturedBurning exact{parameters()};
    const Material m = parameters().material;
    const double beta = 3.0 * m.thermal_expansion * m.bulk_modulus;
    const Point at{37e-6, -41e-6, 0.3e-3};

    Field temperature = [this](double x, double y, double t) { return exact.temperature(x, y, t); };
    Field velocity(int i) const {
        return [this, i](double x, double y, double t) { return exact.velocity(x, y, t)[i]; };
    }
    Field shift(int i) const {
        return [this, i](double x, double y, double t) { return exact.shift(x, y, t)[i]; };
    }
    Field stress(double PlaneStrainStress::*component) const {
        return [this, component](double x, double y, double t) {
            return exact.stress(x, y, t).*component;
        };
    }
    double carried(const Field& f) const {
        const Eigen::Vector2d v = exact.velocity(at.x, at.y, at.t);
        return at.d_t(f) + v.x() * at.d_x(f) + v.y() * at.d_y(f);
    }
};

TEST_F(Burning, RegressesByItsOwnBurnRate) {
    const auto phi = [&](double x, double, double t) { return exact.surface(x, t); };
    const double slope = at.d_x(phi);
    const double surface_temperature = exact.temperature(at.x, exact.surface(at.x, at.t), at.t);
    const double burn_rate =
        m.pyrolysis_prefactor * std::exp(-m.activation_temperature / surface_temperature);
    EXPECT_NEAR(at.d_t(phi) / (-burn_rate * std::hypot(1.0, slope)), 1.0, 1e-7);
}

TEST_F(Burning, CarriesItsMap) {
    for (int i = 0; i < 2; ++i) {
        const double v = exact.velocity(at.x, at.y, at.t)[i];
        EXPECT_NEAR(carried(shift(i)) / -v, 1.0, 1e-6) << i;  // D(xi - x)/Dt = -v
    }
    Eigen::Matrix2d grad_xi = Eigen::Matrix2d::Identity();
    for (int i = 0; i < 2; ++i) {
        grad_xi(i, 0) += at.d_x(shift(i));
        grad_xi(i, 1) += at.d_y(shift(i));
    }
    const Eigen::Matrix2d f = exact.deformation_gradient(at.x, at.y, at.t);
    EXPECT_LT((f * grad_xi - Eigen::Matrix2d::Identity()).norm(), 1e-7);
    EXPECT_GT((f - Eigen::Matrix2d::Identity()).norm(), 0.01) << "or it would show nothing";
}

TEST_F(Burning, HasTheVelocityGradientOfItsVelocity) {
    const Eigen::Matrix2d g = exact.velocity_gradient(at.x, at.y, at.t);
    for (int i = 0; i < 2; ++i) {
        EXPECT_NEAR(g(i, 0), at.d_x(velocity(i)), 1e-6 * g.norm());
        EXPECT_NEAR(g(i, 1), at.d_y(velocity(i)), 1e-6 * g.norm());
    }
}

TEST_F(Burning, BalancesHeat) {
    const double rate = carried(temperature);
    const double divergence = at.d_x(velocity(0)) + at.d_y(velocity(1));
    const double expected = m.density * m.specific_heat * rate -
                            m.thermal_conductivity * at.laplacian(temperature) +
                            beta * exact.temperature(at.x, at.y, at.t) * divergence;
    EXPECT_NEAR(exact.heat_source(at.x, at.y, at.t) / expected, 1.0, 1e-5);
    EXPECT_NEAR(exact.temperature_rate(at.x, at.y, at.t) / rate, 1.0, 1e-6);
}

/// Jaumann's rate written out by components, as no matrix product writes it.
TEST_F(Burning, BalancesStress) {
    const double u_x = at.d_x(velocity(0));
    const double u_y = at.d_y(velocity(0));
    const double v_x = at.d_x(velocity(1));
    const double v_y = at.d_y(velocity(1));
    const double spin = 0.5 * (v_x - u_y);  // counterclockwise
    const PlaneStrainStress s = exact.stress(at.x, at.y, at.t);
    const double hydrostatic = m.lame() * (u_x + v_y) - beta * carried(temperature);
    const PlaneStrainStress source = exact.stress_source(at.x, at.y, at.t);
    const double mu = m.shear_modulus;
    const double size = std::abs(source.xx);
    EXPECT_NEAR(
        source.xx,
        carried(stress(&PlaneStrainStress::xx)) + 2.0 * spin * s.xy - hydrostatic - 2.0 * mu * u_x,
        1e-5 * size);
    EXPECT_NEAR(
        source.yy,
        carried(stress(&PlaneStrainStress::yy)) - 2.0 * spin * s.xy - hydrostatic - 2.0 * mu * v_y,
        1e-5 * size);
    EXPECT_NEAR(source.zz, carried(stress(&PlaneStrainStress::zz)) - hydrostatic, 1e-5 * size);
    EXPECT_NEAR(source.xy,
                carried(stress(&PlaneStrainStress::xy)) - spin * (s.xx - s.yy) - mu * (u_y + v_x),
                1e-5 * size);
}

TEST_F(Burning, BalancesForces) {
    const Eigen::Vector2d b = exact.body_force(at.x, at.y, at.t);
    const double along_x =
        at.d_x(stress(&PlaneStrainStress::xx)) + at.d_y(stress(&PlaneStrainStress::xy));
    const double along_y =
        at.d_x(stress(&PlaneStrainStress::xy)) + at.d_y(stress(&PlaneStrainStress::yy));
    EXPECT_NEAR(b.x() / -along_x, 1.0, 1e-6);
    EXPECT_NEAR(b.y() / -along_y, 1.0, 1e-6);
}

TEST_F(Burning, MeetsFluxAndTractionOnItsSurface) {
    const Point on{at.x, exact.surface(at.x, at.t), at.t};
    const double slope = at.d_x([&](double x, double, double t) { return exact.surface(x, t); });
    const double length = std::hypot(1.0, slope);
    const double burn_rate = m.pyrolysis_prefactor * std::exp(-m.activation_temperature /
                                                              exact.temperature(on.x, on.y, on.t));
    const double conducted =
        m.thermal_conductivity * (on.d_y(temperature) - slope * on.d_x(temperature)) / length;
    const double expected = conducted - 8e6 - m.heat_of_reaction * m.density * burn_rate;
    EXPECT_NEAR(exact.heat_flux(on.x, on.t), expected, 1e-6 * conducted);

    const PlaneStrainStress s = exact.stress(on.x, on.y, on.t);
    const Eigen::Vector2d traction = exact.traction(on.x, on.t);
    EXPECT_NEAR(traction.x(), (-s.xx * slope + s.xy - 2e6 * slope) / length, 1.0);
    EXPECT_NEAR(traction.y(), (-s.xy * slope + s.yy + 2e6) / length, 1.0);
}

TEST_F(Burning, LeavesItsBottomAtRest) {
    const Point bottom{at.x, exact.surface(at.x, at.t) - 200e-6, at.t};
    EXPECT_NEAR(exact.temperature(bottom.x, bottom.y, bottom.t), 300.0, 1e-9);
    EXPECT_LT(exact.velocity(bottom.x, bottom.y, bottom.t).norm(), 1e-15);
    EXPECT_LT(exact.shift(bottom.x, bottom.y, bottom.t).norm(), 1e-18);
    EXPECT_NEAR(bottom.d_y(stress(&PlaneStrainStress::xx)) * 200e-6, 0.0, 1e-6 * 2e8);
}

std::string refusal(const BurningParameters& wrong) {
    try {
        ManufacturedBurning refused(wrong);
    } catch (const std::invalid_argument& problem) {
        return problem.what();
    }
    return "";
}

TEST_F(Burning, RefusesByName) {
    BurningParameters p = parameters();
    p.depth = missing;
    EXPECT_NE(refusal(p).find("depth"), std::string::npos);
    p = parameters();
    p.material.density = -1.0;
    EXPECT_NE(refusal(p).find("density"), std::string::npos);
    p = parameters();
    p.wave_frequency = 1e4;  // the surface would advance somewhere
    EXPECT_NE(refusal(p).find("regression_rate"), std::string::npos);
}

}  // namespace
}  // namespace crawford::reference
