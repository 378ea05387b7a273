// The motion behind random packs: one contact, the next event, a fluid of hard discs of known
// pressure.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "solver/packing/contact.hpp"
#include "solver/packing/event_queue.hpp"
#include "solver/packing/hard_discs.hpp"
#include "solver/packing/pack.hpp"
#include "solver/packing/random.hpp"
#include "tests/solver/packing/packs.hpp"

namespace crawford {
namespace {

using testing::at_rest_with_itself;
using testing::fluid;
using testing::pi;

constexpr double never = std::numeric_limits<double>::infinity();

TEST(Contact, IsWhereTheRimsMeet) {
    // head on: a gap of 3 closes at 2
    EXPECT_DOUBLE_EQ(time_to_contact({5, 0, -2, 0, 2, 0}), 1.5);
    // the rims grow at 1 besides
    EXPECT_DOUBLE_EQ(time_to_contact({5, 0, -2, 0, 2, 1}), 1.0);
    // at rest, and flying apart more slowly than they grow
    EXPECT_DOUBLE_EQ(time_to_contact({5, 0, 0, 0, 2, 1}), 3.0);
    EXPECT_DOUBLE_EQ(time_to_contact({5, 0, 0.5, 0, 2, 1}), 6.0);
    // grazing past at 4, 5: reach 5 is met where the way along is 3
    EXPECT_DOUBLE_EQ(time_to_contact({7, 4, -1, 0, 5, 0}), 4.0);
}

TEST(Contact, NeverComes) {
    EXPECT_EQ(time_to_contact({5, 0, 2, 0, 2, 1}), never) << "apart faster than they grow";
    EXPECT_EQ(time_to_contact({7, 4, -1, 0, 3.9, 0}), never) << "passing";
    EXPECT_EQ(time_to_contact({5, 0, 0, 0, 2, 0}), never) << "at rest";
}

TEST(Contact, OfDiscsThatOverlapByRoundOffIsNowIfTheyCloseIn) {
    EXPECT_EQ(time_to_contact({2 - 1e-15, 0, -1, 0, 2, 0}), 0.0);
    EXPECT_EQ(time_to_contact({2 - 1e-15, 0, 1, 0, 2, 0.5}), never);
}

TEST(Contact, ReboundsInTheFrameOfTheRims) {
    // Normal velocity -3 and a reach that grows at 1: the rims meet at 4 and part at 4.
    const Approach contact{1.2, 1.6, -1.8, -2.4, 2, 1};
    const double push = impulse(contact, 2, 6);
    EXPECT_DOUBLE_EQ(-3 + push / 2 + push / 6, 5);
    // Nothing grows: the energy of normal motion, mu w^2/2, is kept.
    const double still = impulse({1.2, 1.6, -1.8, -2.4, 2, 0}, 2, 6);
    EXPECT_DOUBLE_EQ(-3 + still / 2 + still / 6, 3);
}

TEST(EventQueue, KnowsTheNextAndOfEqualTimesTheFirst) {
    EventQueue queue;
    queue.reset(5);
    EXPECT_EQ(queue.time(queue.next()), never);
    queue.set(4, 2.0);
    EXPECT_EQ(queue.next(), 4u);
    queue.set(3, 1.0);
    queue.set(1, 1.0);
    EXPECT_EQ(queue.next(), 1u);
    queue.set(2, 1.0);
    EXPECT_EQ(queue.next(), 1u);
    queue.set(1, 3.0);
    EXPECT_EQ(queue.next(), 2u);
    EXPECT_EQ(queue.time(1), 3.0);
    queue.reset(1);
    EXPECT_EQ(queue.time(queue.next()), never);
}

TEST(Random, IsTheGeneratorOfTheStandardAndItsUpper53Bits) {
    // [rand.predef]: the 10000th output of a mt19937_64 seeded with 5489 is 9981545732273789042.
    Random random(5489);
    for (int i = 1; i < 10000; ++i) random.unit();
    EXPECT_EQ(random.unit(), static_cast<double>(9981545732273789042U >> 11U) / 9007199254740992.0);
}

/// The smallest distance of two centres, images included, less the diameter.
double smallest_gap(const HardDiscs& moving, const Box& box) {
    Discs pack{.discs = {}, .period = box.height};
    for (const HardDisc& d : moving.discs())
        pack.discs.push_back({.x = d.x, .y = d.y, .radius = d.radius * moving.size()});
    return smallest_gap(pack, box.width);
}

TEST(HardDiscs, KeepMomentumEnergyAndTheirDistance) {
    // Boxes from roomy to barely wider than a disc, where one disc meets several images of another.
    for (const double aspect : {1.0, 6.0, 10.0}) {
        constexpr int count = 12;
        constexpr double fraction = 0.5;
        const Box box{.width = std::sqrt(count * pi / fraction / aspect),
                      .height = std::sqrt(count * pi / fraction * aspect)};
        HardDiscs discs = at_rest_with_itself(fluid(count, fraction, 7, aspect), 1.0);
        const double energy = discs.energy();
        double least = never;
        long collisions = 0;
        for (int i = 0; i < 300; ++i) {
            collisions += discs.advance(0.0, 0.7);
            least = std::min(least, smallest_gap(discs, box));
        }
        double u = 0, v = 0;
        for (const HardDisc& disc : discs.discs()) {
            u += disc.u;
            v += disc.v;
        }
        EXPECT_GT(collisions, 500) << aspect;
        // Round-off of the collisions, each some 1e-16 of a disc's share, at random.
        EXPECT_NEAR(discs.energy() / energy, 1.0, 1e-12) << aspect;
        EXPECT_NEAR(u, 0.0, 1e-12) << aspect;
        EXPECT_NEAR(v, 0.0, 1e-12) << aspect;
        EXPECT_GT(least, -1e-12) << aspect;
    }
}

/// Henderson's equation of state of the hard-disc fluid, Z = P A/(N k T); good to 0.5 % below 0.5.
double compressibility(double fraction) {
    return (1 + fraction * fraction / 8) / ((1 - fraction) * (1 - fraction));
}

TEST(HardDiscs, TakeTheWorkOfGrowthThatTheirPressureDemands) {
    // Discs that grow slowly by d ln(size) raise the energy as if they had been compressed, but for
    // the ideal gas: d ln E = 2 (Z - 1) d ln(size), Z the equation of state.
    constexpr int count = 200;
    constexpr double from = 0.95;
    constexpr int steps = 200;
    double expected = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double size = from + (1 - from) * (i + 0.5) / steps;
        expected += 2 * (compressibility(0.4 * size * size) - 1) * (1 - from) / steps / size;
    }
    double mean = 0.0;
    constexpr int packs = 8;
    for (std::uint64_t seed = 1; seed <= packs; ++seed) {
        HardDiscs discs = at_rest_with_itself(fluid(count, 0.4, seed), from);
        constexpr double growth = 0.001;
        const double energy = discs.energy();
        discs.advance(growth, (1 - from) / growth);
        mean += std::log(discs.energy() / energy) / packs;
    }
    // 2 %: the equation of state 0.3, N - 1 in place of N free momenta 0.5, rims that hit at 1e-3
    // of the thermal speed 0.2, and the scatter of eight runs 0.5.
    EXPECT_NEAR(mean / expected, 1.0, 0.02);
}

}  // namespace
}  // namespace crawford
