#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "solver/materials/disc_overlap.hpp"
#include "solver/materials/material_map.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

constexpr double pi = std::numbers::pi;

TEST(DiscOverlap, IsExact) {
    const auto square = [](double left, double low, double size) {
        return std::array<Vector, 4>{
            {{left, low}, {left + size, low}, {left + size, low + size}, {left, low + size}}};
    };
    EXPECT_NEAR(disc_overlap(square(-2, -2, 4), 1.0), pi, 1e-14);         // disc inside
    EXPECT_NEAR(disc_overlap(square(-0.1, 0.2, 0.3), 1.0), 0.09, 1e-15);  // square inside
    EXPECT_NEAR(disc_overlap(square(0, 0, 5), 1.0), 0.25 * pi, 1e-14);    // a quadrant
    EXPECT_NEAR(disc_overlap(square(-3, 0, 6), 1.0), 0.5 * pi, 1e-14);    // a half
    EXPECT_NEAR(disc_overlap(square(1.5, 0, 1), 1.0), 0.0, 1e-15);        // apart
    // a cap: the part beyond x = 1/2 of the unit disc
    EXPECT_NEAR(disc_overlap(square(0.5, -2, 4), 1.0), pi / 3 - std::sqrt(3.0) / 4, 1e-14);
}

double area_of_discs(const Grid& grid, const MaterialMap& map) {
    double area = 0.0;
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j)
            area += map.fraction()(i, j) * grid.dx() * grid.height(j);
    return area;
}

TEST(MaterialMap, KeepsTheAreaOfDiscsWhereverTheSurfaceIs) {
    // The window is one period deep, so it always holds each disc once, images included.
    const Domain domain{.width = 100e-6, .depth = 120e-6, .nx = 17, .ny = 23, .clustering = 1.0};
    const Grid grid(domain);
    const Discs discs{.discs = {{2e-6, -5e-6, 30e-6}, {-45e-6, -70e-6, 20e-6}}, .period = 120e-6};
    MaterialMap map({.shape = discs, .materials = {ammonium_perchlorate(), htpb_binder()}}, grid);
    const double expected = pi * (900e-12 + 400e-12);
    for (const double depth : {0.0, -13e-6, -777e-6}) {
        SurfaceField surface = testing::wave(grid);
        for (double& height : surface) height += depth;
        map.follow(surface);
        EXPECT_NEAR(area_of_discs(grid, map), expected, 1e-12 * expected) << depth;
    }
}

TEST(MaterialMap, FillsAStripThatEndsInsideACell) {
    const Grid grid({.width = 100e-6, .depth = 100e-6, .nx = 10, .ny = 4});
    const MaterialMap map(
        {.shape = Sandwich{25e-6}, .materials = {ammonium_perchlorate(), htpb_binder()}}, grid);
    EXPECT_NEAR(map.fraction()(3, 0), 0.75, 1e-12);  // -20 to -10 um, covered from -12.5
    EXPECT_NEAR(map.fraction()(4, 0), 0.0, 1e-12);
    EXPECT_NEAR(map.fraction()(7, 0), 1.0, 1e-12);
}

TEST(MaterialMap, ACutCellIsAsSoftAsMaterialsInSeries) {
    const Grid grid({.width = 100e-6, .depth = 100e-6, .nx = 10, .ny = 4});
    const MaterialMap map(
        {.shape = Sandwich{25e-6}, .materials = {ammonium_perchlorate(), htpb_binder()}}, grid);
    EXPECT_NEAR(map.shear_modulus(3, 0), 1.0 / (0.75 / 12500e6 + 0.25 / 2.5e6), 1e-3);
    EXPECT_NEAR(map.thermal_expansion(3, 0), 0.75e-5 + 0.25e-4, 1e-15);
    EXPECT_NEAR(map.thermal_stress(4, 0, ThermalStress::three_alpha_bulk), 3 * 1e-4 * 10670e6,
                1e-3);
    EXPECT_NEAR(map.thermal_stress(4, 0, ThermalStress::alpha_bulk), 1e-4 * 10670e6, 1e-3);
}

}  // namespace
}  // namespace crawford
