#include <gtest/gtest.h>

#include "solver/burning/burn_rate.hpp"
#include "solver/burning/surface_motion.hpp"
#include "tests/solver/scenes.hpp"

namespace crawford {
namespace {

TEST(BurnRate, IsTheArrheniusLawOfEachMaterial) {
    const Scene scene = testing::sandwich(8, 4);
    const Grid grid(scene.domain);
    const MaterialMap map(scene.morphology, grid);
    const BurningLaw law(Regression::pyrolysis, scene.surface);
    // By hand from Table 1 at 950 K, A in m/s.
    EXPECT_NEAR(law.burn_rate(map, 1.0, 950.0), 1450.0 * std::exp(-11000.0 / 950.0), 1e-15);
    EXPECT_NEAR(law.burn_rate(map, 0.0, 950.0), 10.36 * std::exp(-7500.0 / 950.0), 1e-15);
    const double rate = 10.36 * std::exp(-7500.0 / 950.0);
    EXPECT_NEAR(law.heat_flux(map, 0.0, 950.0).value, 6.6944e6 - 418400.0 * 920.0 * rate, 1e-6);
    const double step = 1e-3;
    const double slope = (law.heat_flux(map, 0.3, 950.0 + step).value -
                          law.heat_flux(map, 0.3, 950.0 - step).value) /
                         (2.0 * step);
    EXPECT_NEAR(law.heat_flux(map, 0.3, 950.0).slope, slope, 1e-6 * std::abs(slope));
}

TEST(BurnRate, AveragesOverTheTrueLengthOfTheSurface) {
    const Grid grid({.width = 4.0, .depth = 1.0, .nx = 4, .ny = 4});
    // Two level segments that burn at 1, two at 45 degrees that burn at 2 and end at nodes shared
    // with neither.
    const SurfaceField surface{0.0, 0.0, 0.0, 1.0};
    const SurfaceField rate{1.0, 1.0, 1.0, 3.0};
    const double slanted = std::sqrt(2.0);
    EXPECT_NEAR(mean_burn_rate(grid, surface, rate),
                (2.0 + 2.0 * 2.0 * slanted) / (2.0 + 2.0 * slanted), 1e-14);
}

TEST(SurfaceMotion, BurnsASlopeAlongItsNormal) {
    const Grid grid({.width = 16.0, .depth = 1.0, .nx = 16, .ny = 4});
    SurfaceField ridge;
    for (int i = 0; i < 16; ++i) ridge.push_back(0.75 * std::abs(i - 8));
    const SurfaceField rate = surface_rate(grid, ridge, SurfaceField(16, 2.0), {});
    EXPECT_NEAR(rate[4], -2.5, 1e-12);   // slope -3/4: sqrt(1 + 9/16) = 5/4
    EXPECT_NEAR(rate[12], -2.5, 1e-12);  // slope +3/4
    // A valley is a corner that information leaves on both sides: it burns as the level it is.
    EXPECT_NEAR(rate[8], -2.0, 1e-12);
    // A ridge is run into from both sides: it burns as its flanks.
    EXPECT_NEAR(rate[0], -2.5, 1e-12);
}

TEST(SurfaceMotion, CarriesTheSurfaceWithTheMaterialWhereAsked) {
    const Grid grid({.width = 8.0, .depth = 1.0, .nx = 8, .ny = 4});
    const SurfaceField level(8, 0.0);
    const SurfaceField rate =
        surface_rate(grid, level, SurfaceField(8, 2.0), std::vector<Vector>(8, Vector(5.0, 0.25)));
    for (const double r : rate) EXPECT_NEAR(r, -1.75, 1e-14);
}

}  // namespace
}  // namespace crawford
