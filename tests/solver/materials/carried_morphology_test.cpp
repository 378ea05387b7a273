// A morphology that the solid carries: it stands where the reference map says the material came
// from.

#include <gtest/gtest.h>

#include <numbers>

#include "base/errors.hpp"
#include "solver/materials/material_map.hpp"
#include "solver/materials/strip_overlap.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

constexpr double pi = std::numbers::pi;

Morphology propellant(Shape shape, Indicator indicator) {
    return {.shape = std::move(shape),
            .materials = {ammonium_perchlorate(), htpb_binder()},
            .indicator = indicator};
}

const Discs discs{.discs = {{2e-6, -5e-6, 30e-6}, {-45e-6, -70e-6, 20e-6}}, .period = 120e-6};
const Domain domain{.width = 100e-6, .depth = 120e-6, .nx = 17, .ny = 23, .clustering = 1.0};

/// A shift that depends on the place below the surface.
template <class Function>
NodeVectors shifts(const Grid& grid, const SurfaceField& surface, const Function& at) {
    NodeVectors shift(grid.node_columns(), grid.rows() + 1);
    for (int i = 0; i < shift.columns(); ++i)
        for (int j = 0; j < shift.rows(); ++j)
            shift(i, j) = at(grid.x(i), surface[size_t(i)] + grid.eta(j));
    return shift;
}

void expect_equal_fractions(const MaterialMap& a, const MaterialMap& b) {
    for (size_t k = 0; k < a.fraction().values().size(); ++k)
        EXPECT_NEAR(a.fraction().values()[k], b.fraction().values()[k], 1e-9) << k;
}

TEST(StripOverlap, IsExact) {
    const std::array<Vector, 4> square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    EXPECT_NEAR(strip_overlap(square, 2.0), 4.0, 1e-14);
    EXPECT_NEAR(strip_overlap(square, 0.25), 1.0, 1e-14);
    const std::array<Vector, 4> beside{{{2, -1}, {3, -1}, {3, 1}, {2, 1}}};
    EXPECT_NEAR(strip_overlap(beside, 1.0), 0.0, 1e-14);
    EXPECT_NEAR(strip_overlap(beside, 2.25), 0.5, 1e-14);
    const std::array<Vector, 4> diamond{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
    EXPECT_NEAR(strip_overlap(diamond, 0.5), 1.5, 1e-14);  // 2 less two tips of 1/4
}

/// Far enough for periodic images to come in that the laboratory's window does not reach.
TEST(CarriedMorphology, MovesAsAWholeWithTheSolid) {
    const Grid grid(domain);
    const SurfaceField surface = testing::wave(grid);
    for (const Vector& shift : {Vector(-47.3e-6, -61.9e-6), Vector(47.3e-6, 61.9e-6)}) {
        Discs moved = discs;
        for (Disc& disc : moved.discs) {
            disc.x -= shift.x();
            disc.y -= shift.y();
        }
        MaterialMap carried(propellant(discs, Indicator::reference_map), grid);
        MaterialMap fixed(propellant(moved, Indicator::laboratory), grid);
        carried.follow(surface, shifts(grid, surface, [&](double, double) { return shift; }));
        fixed.follow(surface);
        expect_equal_fractions(carried, fixed);
    }
}

TEST(CarriedMorphology, IsThatOfTheLaboratoryWhileNothingMoves) {
    const Grid grid(domain);
    const SurfaceField surface = testing::wave(grid);
    for (const Shape& shape : {Shape(discs), Shape(Sandwich{25e-6})}) {
        MaterialMap carried(propellant(shape, Indicator::reference_map), grid);
        MaterialMap fixed(propellant(shape, Indicator::laboratory), grid);
        carried.follow(surface, NodeVectors(grid.node_columns(), grid.rows() + 1));
        fixed.follow(surface);
        expect_equal_fractions(carried, fixed);
        fixed.follow(surface,
                     shifts(grid, surface, [](double, double) { return Vector(1e-6, 1e-6); }));
        carried.follow(surface);
        expect_equal_fractions(carried, fixed);
    }
}

/// xi = (x + 0.3 y, 0.4 y): every cell came from a parallelogram of 0.4 times its area.
TEST(CarriedMorphology, KeepsItsAreaInTheReferenceConfiguration) {
    const Grid grid(domain);
    const SurfaceField surface = testing::wave(grid);
    const Discs one{.discs = {{-3e-6, -20e-6, 11e-6}}, .period = 1.0};
    MaterialMap map(propellant(one, Indicator::reference_map), grid);
    map.follow(surface,
               shifts(grid, surface, [](double, double y) { return Vector(0.3 * y, -0.6 * y); }));
    double area = 0.0;
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j)
            area += map.fraction()(i, j) * 0.4 * grid.dx() * grid.height(j);
    EXPECT_NEAR(area, pi * 121e-12, 1e-9 * area);
}

TEST(CarriedMorphology, AStripWidensWithTheSolidAndFillsWhatCameFromBeyondTheSides) {
    const Grid grid({.width = 100e-6, .depth = 100e-6, .nx = 20, .ny = 4});
    const SurfaceField level(20, 0.0);
    MaterialMap map(propellant(Sandwich{20e-6}, Indicator::reference_map), grid);
    map.follow(level, NodeVectors(20, 5, Vector(92e-6, 0.0)));  // the strip stands at x = 8 um
    EXPECT_NEAR(map.fraction()(9, 2), 0.6, 1e-9);               // -5 to 0 um
    EXPECT_NEAR(map.fraction()(11, 2), 0.0, 1e-9);              // 5 to 10 um
    EXPECT_NEAR(map.fraction()(13, 2), 0.4, 1e-9);              // 15 to 20 um
}

TEST(CarriedMorphology, HalfAScenesMapIsHalfOfTheWhole) {
    const Domain whole{.width = 100e-6, .depth = 100e-6, .nx = 20, .ny = 6};
    Domain half = whole;
    half.half = true;
    const Grid both(whole);
    const Grid right(half);
    const auto squeezed = [](double x, double y) {
        return Vector(5e-6 * std::sin(2.0 * pi * x / 100e-6), 0.1 * y);
    };
    const SurfaceField level(20, 0.0);
    const SurfaceField half_level(11, 0.0);
    MaterialMap map(propellant(Sandwich{23e-6}, Indicator::reference_map), both);
    MaterialMap map_of_half(propellant(Sandwich{23e-6}, Indicator::reference_map), right);
    map.follow(level, shifts(both, level, squeezed));
    map_of_half.follow(half_level, shifts(right, half_level, squeezed));
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 6; ++j) {
            EXPECT_NEAR(map_of_half.fraction()(i, j), map.fraction()(10 + i, j), 1e-9);
            EXPECT_NEAR(map.fraction()(9 - i, j), map.fraction()(10 + i, j), 1e-9);
        }
}

TEST(CarriedMorphology, RefusesACellTurnedInsideOut) {
    const Grid grid({.width = 100e-6, .depth = 100e-6, .nx = 20, .ny = 4});
    const SurfaceField level(20, 0.0);
    MaterialMap map(propellant(Sandwich{20e-6}, Indicator::reference_map), grid);
    NodeVectors shift(20, 5);
    shift(3, 2) = Vector(30e-6, 0.0);
    EXPECT_THROW(map.follow(level, shift), NumericalFailure);
}

Scene carried_sandwich() {
    Scene scene = testing::sandwich(16, 24);
    scene.morphology.indicator = Indicator::reference_map;
    scene.time.step = 100e-6;
    return scene;
}

TEST(CarriedMorphology, GoesOnFromAStateBitForBit) {
    for (const Stepping scheme : {Stepping::euler, Stepping::bdf2}) {
        Scene scene = carried_sandwich();
        scene.time.scheme = scheme;
        Simulation unbroken(scene);
        for (int k = 0; k < 10; ++k) run_steps(unbroken, 1);
        Simulation restarted(scene);
        restarted.restore(unbroken.state());
        EXPECT_EQ(restarted.material_fraction().values(), unbroken.material_fraction().values());
        for (int k = 0; k < 5; ++k) {
            run_steps(unbroken, 1);
            run_steps(restarted, 1);
        }
        EXPECT_EQ(restarted.state().temperature.values(), unbroken.state().temperature.values());
        EXPECT_EQ(restarted.state().velocity.values(), unbroken.state().velocity.values());
        EXPECT_EQ(restarted.state().stress.pressure.values(),
                  unbroken.state().stress.pressure.values());
    }
}

/// The AP pushes inward before the binder bulges: the cell beside the interface, all binder in the
/// laboratory, holds as much AP as has moved in, and the solid is left in equilibrium with it.
TEST(CarriedMorphology, AStripTakesItsInterfaceAlong) {
    Simulation simulation(carried_sandwich());
    const int interface = 10;  // the node column at x = 30 um
    const int top = simulation.grid().rows();
    EXPECT_EQ(simulation.material_fraction()(interface - 1, top - 1), 0.0);
    for (int k = 0; k < 100; ++k) run_steps(simulation, 1);
    const NodeVectors& shift = simulation.state().reference_shift;
    const double inward = 0.5 * (shift(interface, top).x() + shift(interface, top - 1).x());
    ASSERT_GT(inward, 0.1e-6);
    EXPECT_NEAR(simulation.material_fraction()(interface - 1, top - 1),
                inward / simulation.grid().dx(), 0.2 * inward / simulation.grid().dx());
    EXPECT_LT(simulation.summary().residual, 1e-12);
}

}  // namespace
}  // namespace crawford
