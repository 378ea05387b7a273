// The structure of a fluid of discs, thin and dense: its pair distribution against what is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "solver/packing/hard_discs.hpp"
#include "solver/packing/pack.hpp"
#include "tests/solver/packing/packs.hpp"

namespace crawford {
namespace {

using testing::at_rest_with_itself;
using testing::fluid;
using testing::PairCounts;
using testing::pi;

TEST(HardDiscs, HaveTheStructureOfAThinFluid) {
    // To first order in the density g(r) = 1 + rho (area that two discs of radius D at distance r
    // share), and 1 beyond 2 D.
    constexpr int count = 100;
    constexpr double fraction = 0.1;
    const double side = std::sqrt(count * pi / fraction);
    constexpr double width = 0.25;
    PairCounts counts(width, 3.0, 9);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        HardDiscs discs = at_rest_with_itself(fluid(count, fraction, seed), 1.0);
        for (int i = 0; i < 300; ++i) {
            discs.advance(0.0, 8.0);  // about a mean free path
            std::vector<std::array<double, 2>> centres;
            for (const HardDisc& d : discs.discs()) centres.push_back({d.x, d.y});
            counts.add(centres, {side, side}, 2.0);
        }
    }
    const auto shared = [](double r) {
        return r < 2 ? 2 * std::acos(r / 2) - r / 2 * std::sqrt(4 - r * r) : 0.0;
    };
    EXPECT_EQ(counts.count(0), 0.0) << "closer than contact";
    for (std::size_t bin = 1; bin <= 8; ++bin) {
        double expected = 0, area = 0;
        for (int k = 0; k < 100; ++k) {
            const double r = 1 + width * (static_cast<double>(bin - 1) + (k + 0.5) / 100);
            expected += r * (1 + 4 * fraction / pi * shared(r));
            area += r;
        }
        expected /= area;
        // Second order: at contact g is (1 - 7 phi/16)/(1 - phi)^2 = 1.181, first order 1.156, and
        // it falls from there; 1/N of a smaller number is what a fixed number of discs adds. Then
        // three standard deviations.
        const double bound = (bin <= 4 ? 0.025 : 0.01) + 3 / std::sqrt(counts.count(bin));
        EXPECT_NEAR(counts.g(bin), expected, bound) << bin;
    }
    // and the bounds can tell it from an ideal gas
    EXPECT_GT(counts.g(1), 1.08);
}

TEST(Pack, HasTheStructureOfADenseFluid) {
    // Equal discs at 0.6: g is largest at contact, has its second shell near two diameters with a
    // trough between, and tends to 1.
    constexpr double diameter = 20e-6;
    constexpr int count = 200;
    constexpr double width = 0.1;
    PairCounts counts(width, 6.0, 51);
    constexpr int packs = 5;
    for (std::uint64_t seed = 1; seed <= packs; ++seed) {
        PackRecipe recipe{.width = 15 * diameter,
                          .discs = {{diameter / 2, count}},
                          .area_fraction = 0.6,
                          .smallest_gap = 0.0,
                          .seed = seed};
        const Discs pack = random_pack(recipe);
        std::vector<std::array<double, 2>> centres;
        for (const Disc& disc : pack.discs) centres.push_back({disc.x, disc.y});
        counts.add(centres, {recipe.width, pack.period}, diameter);
    }
    std::vector<double> g(51);
    for (std::size_t bin = 1; bin < g.size(); ++bin) g[bin] = counts.g(bin);
    EXPECT_EQ(counts.count(0), 0.0);
    EXPECT_EQ(std::max_element(g.begin(), g.end()) - g.begin(), 1);
    const auto trough = std::min_element(g.begin() + 1, g.end()) - g.begin();
    EXPECT_TRUE(trough >= 5 && trough <= 8) << trough;  // 1.4 to 1.8 diameters, where it is flat
    const auto shell = std::max_element(g.begin() + trough, g.end()) - g.begin();
    EXPECT_TRUE(shell >= 9 && shell <= 12) << shell;  // 1.8 to 2.2 diameters
    double far = 0;
    for (std::size_t bin = 41; bin <= 50; ++bin) far += g[bin] / 10;
    EXPECT_NEAR(far, 1.0, 0.02);
}

}  // namespace
}  // namespace crawford
