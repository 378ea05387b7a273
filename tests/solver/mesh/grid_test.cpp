#include <gtest/gtest.h>

#include "solver/mesh/cell.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

TEST(Lattice, StartsAtZeroWhateverItsValues) {
    const NodeVectors vectors(3, 5);
    for (const Vector& value : vectors.values()) EXPECT_EQ(value, Vector::Zero());
    const NodeField numbers(3, 5);
    for (const double value : numbers.values()) EXPECT_EQ(value, 0.0);
}

TEST(Grid, ClustersAsThePaperSays) {
    // Paper sec. 5.1 and 5.2: c = 2, ny = 96 gives 1.25 um for 480 um, 1.875 ("2") um for 720 um;
    // d(eta)/d(etahat) is 2^-c at the surface and 1 + 2c at the bottom.
    const Grid grid({.width = 240e-6, .depth = 480e-6, .nx = 32, .ny = 96, .clustering = 2.0});
    EXPECT_DOUBLE_EQ(grid.eta(0), -480e-6);
    EXPECT_DOUBLE_EQ(grid.eta(96), 0.0);
    EXPECT_NEAR(grid.metric(96), 1.25e-6, 1e-18);
    EXPECT_NEAR(grid.metric(0), 5.0 * 5e-6, 1e-17);
    for (int j = 1; j < 96; ++j)
        EXPECT_NEAR(grid.metric(j), 0.5 * (grid.eta(j + 1) - grid.eta(j - 1)),
                    0.01 * grid.metric(j))
            << j;
}

TEST(Grid, ClustersItsColumnsAboutAStrip) {
    for (const bool half : {false, true}) {
        const Domain domain{
            .width = 240e-6, .depth = 480e-6, .nx = 64, .ny = 4, .clustering_x = 2.0, .half = half};
        const Grid grid(domain, 30e-6);
        int on_interface = -1;
        for (int i = 0; i < grid.cell_columns(); ++i) {
            if (std::abs(grid.x(i) - 30e-6) < 1e-15) on_interface = i;
            EXPECT_NEAR(grid.dx(i), grid.x(i + 1) - grid.x(i), 1e-18);
            EXPECT_NEAR(grid.metric_x(i, 0.5), grid.dx(i), 0.05 * grid.dx(i)) << i;
        }
        ASSERT_GT(on_interface, 0);
        EXPECT_NEAR(grid.metric_x(on_interface), 240e-6 / 64 / 4, 1e-15);
        EXPECT_NEAR(grid.x(grid.cell_columns()), 120e-6, 1e-15);
        EXPECT_NEAR(grid.x(0), half ? 0.0 : -120e-6, 1e-15);
        EXPECT_NEAR(grid.width(), half ? 120e-6 : 240e-6, 1e-15);
    }
}

TEST(Grid, WrapsAroundOrEndsAtAPlaneOfSymmetry) {
    const Grid whole({.nx = 8, .ny = 4});
    const Grid half({.nx = 8, .ny = 4, .half = true});
    EXPECT_EQ(whole.node_columns(), 8);
    EXPECT_EQ(whole.right_node(7), 0);
    EXPECT_EQ(half.node_columns(), 5);
    EXPECT_EQ(half.right_node(3), 4);
    EXPECT_DOUBLE_EQ(half.x(0), 0.0);
    EXPECT_DOUBLE_EQ(half.x(4), 120e-6);
    EXPECT_NEAR(whole.x(4), 0.0, 1e-20);
}

TEST(Grid, KnowsTheColumnsBeyondItsSides) {
    const Grid whole({.nx = 8, .ny = 4});
    EXPECT_EQ(whole.node_column(-1).index, 7);
    EXPECT_EQ(whole.node_column(9).index, 1);
    EXPECT_FALSE(whole.node_column(-1).mirrored);
    const Grid half({.nx = 8, .ny = 4, .half = true});
    EXPECT_EQ(half.node_column(-2).index, 2);
    EXPECT_TRUE(half.node_column(-2).mirrored);
    EXPECT_EQ(half.node_column(5).index, 3);
    EXPECT_TRUE(half.node_column(5).mirrored);
    EXPECT_FALSE(half.node_column(4).mirrored);
}

TEST(Cell, GradientOfALinearFieldIsExactOnASlope) {
    const Grid grid({.width = 1.0, .depth = 1.0, .nx = 8, .ny = 4, .clustering = 1.5});
    const SurfaceField surface = testing::wave(grid);
    const auto linear = [&](double x, double y) { return 3.0 * x - 2.0 * y; };
    for (int i = 0; i < 7; ++i)
        for (int j = 0; j < 4; ++j) {
            std::array<double, 4> f;
            const auto nodes = corners(grid, i, j);
            for (size_t k = 0; k < 4; ++k)
                f[k] =
                    linear(grid.x(nodes[k].i), surface[size_t(nodes[k].i)] + grid.eta(nodes[k].j));
            const Vector g = gradient(Cell(grid, surface, i, j), f, {0.2, 0.9});
            EXPECT_NEAR(g.x(), 3.0, 1e-12);
            EXPECT_NEAR(g.y(), -2.0, 1e-12);
        }
}

}  // namespace
}  // namespace crawford
