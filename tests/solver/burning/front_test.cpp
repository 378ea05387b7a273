// The front where two materials meet in the surface.
#include <gtest/gtest.h>

#include <numeric>

#include "solver/burning/front_motion.hpp"
#include "solver/burning/surface_motion.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

TEST(SurfacePieces, EndWhereADiscTrulyCrossesTheSegment) {
    // Level at y = 0.6 through a disc of radius 1 about the origin: |x| <= 0.8.
    const auto covered = covered_by_disc({Vector(-2.0, 0.6), Vector(2.0, 0.6)}, 1.0);
    ASSERT_TRUE(covered);
    EXPECT_NEAR(covered->from, 0.3, 1e-15);
    EXPECT_NEAR(covered->to, 0.7, 1e-15);
    EXPECT_FALSE(covered_by_disc({Vector(-2.0, 1.0), Vector(2.0, 1.0)}, 1.0)) << "only touched";
    EXPECT_FALSE(covered_by_disc({Vector(2.0, 0.0), Vector(3.0, 0.0)}, 1.0));
}

TEST(SurfacePieces, ShareASegmentBetweenWhatLiesInIt) {
    const SegmentPieces pieces = pieces_of({{.from = 0.25, .to = 0.75}}, 1.0, {1.0, 1.0});
    ASSERT_EQ(pieces.size(), 3U);
    EXPECT_EQ(pieces[0].fraction, 0.0);
    EXPECT_EQ(pieces[1].fraction, 1.0);
    EXPECT_EQ(pieces[1].to, 0.75);
    EXPECT_EQ(pieces_of({{.from = 0.0, .to = 1.0}}, 1.0, {1.0, 1.0}).size(), 1U);
    EXPECT_EQ(pieces_of({{.from = 1e-9, .to = 1.0}}, 1.0, {1.0, 1.0}).size(), 1U) << "round-off";
    EXPECT_EQ(pieces_of({}, 1.0, {1.0, 1.0}).front().fraction, 0.0);
}

TEST(SurfacePieces, DivideTheTemperatureAsTheResistance) {
    // 0.25 of conductivity 1 beside 0.75 of conductivity 3: half of the drop lies in each.
    const SegmentPieces pieces = pieces_of({{.from = 0.25, .to = 1.0}}, 1.0, {3.0, 1.0});
    EXPECT_NEAR(pieces[0].right_at_end, 0.5, 1e-15);
    EXPECT_NEAR(pieces[0].right_in_middle, 0.25, 1e-15);
    EXPECT_NEAR(pieces[1].right_at_end, 1.0, 1e-15);
    double whole = 0.0;
    for (const PieceShare& share : shares_of(pieces))
        whole += std::accumulate(share.of_node.begin(), share.of_node.end(), 0.0);
    EXPECT_NEAR(whole, 1.0, 1e-15);
}

TEST(SurfacePieces, OfASandwichEndAtItsStrip) {
    const Scene scene = testing::sandwich(16, 4);  // columns of 15 um, strip from -30 to 30 um
    const Grid grid(scene.domain);
    const MaterialMap on_nodes(scene.morphology, grid, scene.numerics);
    for (const SegmentPieces& pieces : on_nodes.surface_pieces()) EXPECT_EQ(pieces.size(), 1U);
    Morphology wider = scene.morphology;
    wider.shape = Sandwich{72e-6};
    const MaterialMap between(wider, grid, scene.numerics);
    EXPECT_NEAR(between.surface_pieces()[10].front().to, 0.4, 1e-12);
    EXPECT_EQ(between.surface_pieces()[10].front().fraction, 0.0);
    Numerics mean = scene.numerics;
    mean.front = Front::mean_of_materials;
    EXPECT_NEAR(MaterialMap(wider, grid, mean).surface_pieces()[10].front().fraction, 0.6, 1e-12);
}

TEST(SurfaceMotion, TheFasterSideLeadsAndDragsTheOther) {
    // Rates of 5 and 3: the plane rises at 4/3 from the crossing, halfway between nodes 3 and 4.
    const Grid grid({.width = 8.0, .depth = 1.0, .nx = 8, .ny = 4});
    SurfacePieces pieces(8, {{0.0, 1.0, 1.0}});
    for (int i = 0; i < 3; ++i) pieces[size_t(i)] = {{0.0, 1.0, 0.0}};
    pieces[3] = pieces_of({{.from = 0.5, .to = 1.0}}, 1.0, {1.0, 1.0});
    pieces[7] = pieces_of({{.from = 0.0, .to = 0.5}}, 1.0, {1.0, 1.0});
    const RateOfMaterial rate = [](double fraction, const SurfacePlace&) {
        return fraction == 1.0 ? 5.0 : 3.0;
    };
    SurfaceField surface(8, 0.0);
    EXPECT_NEAR(surface_rate(grid, surface, pieces, rate, {}, 1e-3)[3], -3.0, 1e-12)
        << "the plane has not come down to it yet";
    surface[3] = 0.5 * 4.0 / 3.0;
    for (int i = 0; i < 3; ++i) surface[size_t(i)] = (3.5 - i) * 4.0 / 3.0;
    const SurfaceField dragged = surface_rate(grid, surface, pieces, rate, {}, 1e-3);
    EXPECT_NEAR(dragged[3], -5.0, 1e-9) << "on the plane, at the leader's speed";
    EXPECT_NEAR(dragged[2], -5.0, 1e-9) << "3 sqrt(1 + (4/3)^2)";
    EXPECT_NEAR(dragged[4], -5.0, 1e-12);
}

TEST(SurfaceMotion, DoesNotDragWhatBurnsAsFast) {
    const Grid grid({.width = 4.0, .depth = 1.0, .nx = 4, .ny = 4});
    SurfacePieces pieces(4, {{0.0, 1.0, 1.0}});
    pieces[1] = pieces_of({{.from = 0.0, .to = 0.5}}, 1.0, {1.0, 1.0});
    pieces[2] = pieces_of({{.from = 0.5, .to = 1.0}}, 1.0, {1.0, 1.0});
    const SurfaceField surface{0.0, 0.0, 0.3, 0.0};
    const RateOfMaterial none = [](double, const SurfacePlace&) { return 0.0; };
    for (const double r : surface_rate(grid, surface, pieces, none, {}, 1e-3)) EXPECT_EQ(r, 0.0);
}

TEST(BurnRate, OfPiecesIsTheirMeanOverTheTrueLength) {
    const Grid grid({.width = 2.0, .depth = 1.0, .nx = 2, .ny = 4});
    SurfacePieces pieces(2, {{0.0, 1.0, 0.0}});
    pieces[0] = pieces_of({{.from = 0.0, .to = 0.25}}, 1.0, {1.0, 1.0});
    const RateOfMaterial rate = [](double fraction, const SurfacePlace&) {
        return fraction == 1.0 ? 5.0 : 1.0;
    };
    const SurfaceField sloped{0.0, 1.0};
    EXPECT_NEAR(mean_over_pieces(grid, sloped, pieces, rate), 0.5 * (0.25 * 5.0 + 0.75) + 0.5,
                1e-14);
}

TEST(BurnRate, OfANodeBetweenMaterialsIsThatOfTheFasterOrOfTheirMean) {
    const Scene scene = testing::sandwich(16, 4);  // an edge of the strip at node 6
    const Grid grid(scene.domain);
    const MaterialMap materials(scene.morphology, grid, scene.numerics);
    const BurningLaw law(Regression::pyrolysis, scene.surface);
    const NodeField temperature(grid.node_columns(), grid.rows() + 1, 950.0);
    const double strip = law.burn_rate(materials, 0.0, 950.0);
    const double outer = law.burn_rate(materials, 1.0, 950.0);
    const auto rate = [&](Front front) {
        return front_motion(front, grid, materials, law)->burn_rate(temperature);
    };
    const SurfaceField faster = rate(Front::faster_side);
    EXPECT_DOUBLE_EQ(faster[0], outer);
    EXPECT_DOUBLE_EQ(faster[8], strip);
    EXPECT_DOUBLE_EQ(faster[6], std::max(outer, strip));
    EXPECT_DOUBLE_EQ(rate(Front::mean_of_materials)[6], law.burn_rate(materials, 0.5, 950.0));
}

}  // namespace
}  // namespace crawford
