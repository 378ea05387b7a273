// What a cell that an interface cuts is made of.

#include <gtest/gtest.h>

#include <numbers>

#include "solver/materials/interface_normal.hpp"
#include "solver/materials/material_map.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

constexpr double outer = 0.405;  // AP, binder [W/(m K)]
constexpr double inner = 0.276;

Morphology strip() {
    return {.shape = Sandwich{25e-6}, .materials = {ammonium_perchlorate(), htpb_binder()}};
}
const Domain domain{.width = 100e-6, .depth = 100e-6, .nx = 10, .ny = 4};  // cell 3: 3/4 AP

Numerics conducting(CutConductivity form) {
    Numerics numerics;
    numerics.cut_cell_conductivity = form;
    return numerics;
}

TEST(CutCells, ConductAsTheSceneSays) {
    const Grid grid(domain);
    const double parallel = 0.75 * outer + 0.25 * inner;
    const double series = 1.0 / (0.75 / outer + 0.25 / inner);
    const MaterialMap arithmetic(strip(), grid, conducting(CutConductivity::arithmetic));
    EXPECT_NEAR(arithmetic.thermal_conductivity(3, 0), parallel, 1e-12);
    EXPECT_EQ(arithmetic.further_conductivity(3, 0).norm(), 0.0);
    const MaterialMap harmonic(strip(), grid, conducting(CutConductivity::harmonic));
    EXPECT_NEAR(harmonic.thermal_conductivity(3, 0), series, 1e-12);
    EXPECT_EQ(harmonic.further_conductivity(3, 0).norm(), 0.0);
    const MaterialMap laminate(strip(), grid, conducting(CutConductivity::laminate));
    EXPECT_NEAR(laminate.thermal_conductivity(3, 0), parallel, 1e-12);
    const Eigen::Matrix2d further = laminate.further_conductivity(3, 0);
    EXPECT_NEAR(further(0, 0), series - parallel, 1e-12);
    EXPECT_NEAR(further(1, 1), 0.0, 1e-12);
    EXPECT_NEAR(further(0, 1), 0.0, 1e-12);
    EXPECT_EQ(laminate.further_conductivity(4, 0).norm(), 0.0) << "a whole cell";
}

TEST(CutCells, AreAsStiffAsTheSceneSays) {
    const Grid grid(domain);
    Numerics numerics;
    numerics.cut_cell_moduli = CutModuli::arithmetic;
    const MaterialMap map(strip(), grid, numerics);
    EXPECT_NEAR(map.shear_modulus(3, 0), 0.75 * 12500e6 + 0.25 * 2.5e6, 1.0);
    EXPECT_NEAR(map.bulk_modulus(3, 0), 0.75 * 14950e6 + 0.25 * 10670e6, 1.0);
}

/// Fractions that rise evenly in the laboratory rise aslant on a grid that slopes.
TEST(InterfaceNormal, IsThatOfAnEvenRiseOnASlopingGrid) {
    const Grid grid({.width = 100e-6, .depth = 100e-6, .nx = 20, .ny = 20, .clustering = 1.0});
    SurfaceField slope;
    for (int i = 0; i < grid.node_columns(); ++i) slope.push_back(0.3 * grid.x(i));
    const Vector rise = Vector(0.6, -0.8);
    CellField fraction(20, 20);
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) {
            const double x = grid.x(i) + 0.5 * grid.dx();
            const double y = 0.3 * x + 0.5 * (grid.eta(j) + grid.eta(j + 1));
            fraction(i, j) = 0.5 + rise.dot(Vector(x, y)) / 1e-3;
        }
    for (const int j : {0, 10, 19}) {
        const Vector normal = interface_normal(grid, slope, fraction, 10, j);
        EXPECT_NEAR(normal.x(), rise.x(), 1e-9) << j;
        EXPECT_NEAR(normal.y(), rise.y(), 1e-9) << j;
    }
}

TEST(InterfaceNormal, OfACirclePointsToItsCentreWithinFiveDegrees) {
    const Grid grid({.width = 100e-6, .depth = 100e-6, .nx = 32, .ny = 32, .clustering = 0.0});
    const Vector centre(1.3e-6, -48e-6);
    const Discs disc{.discs = {{centre.x(), centre.y(), 30e-6}}, .period = 1.0};
    const MaterialMap map({.shape = disc, .materials = {ammonium_perchlorate(), htpb_binder()}},
                          grid);
    const SurfaceField level(32, 0.0);
    int cut = 0;
    for (int i = 0; i < 32; ++i)
        for (int j = 0; j < 32; ++j) {
            if (map.fraction()(i, j) < 0.02 || map.fraction()(i, j) > 0.98) continue;
            const Vector place(grid.x(i) + 0.5 * grid.dx(), grid.eta(j) + 0.5 * grid.height(j));
            const Vector inward = (centre - place).normalized();
            const Vector normal = interface_normal(grid, level, map.fraction(), i, j);
            EXPECT_GT(normal.dot(inward), std::cos(5.0 * std::numbers::pi / 180.0))
                << i << ' ' << j;
            ++cut;
        }
    EXPECT_GT(cut, 50);
}

TEST(InterfaceNormal, IsNoneWhereFractionsAreEven) {
    const Grid grid(domain);
    const CellField even(10, 4, 0.5);
    EXPECT_EQ(interface_normal(grid, SurfaceField(10, 0.0), even, 3, 2).norm(), 0.0);
}

}  // namespace
}  // namespace crawford
