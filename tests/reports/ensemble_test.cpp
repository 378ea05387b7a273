/// Spreads against tables and by trial; points of an ensemble.

#include "reports/ensemble.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "base/errors.hpp"
#include "reports/ensemble_json.hpp"
#include "reports/page/ensemble.hpp"

namespace crawford::reports {
namespace {

using testing::HasSubstr;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(Spread, IsThatOfTheTables) {
    const Spread found = spread({1.0, 2.0, 3.0, 4.0, 5.0}, 0.95);
    EXPECT_EQ(found.count, 5);
    EXPECT_DOUBLE_EQ(found.mean, 3.0);
    EXPECT_NEAR(found.standard_deviation, std::sqrt(2.5), 1e-15);
    EXPECT_NEAR(found.half_width, 2.776445105 * std::sqrt(2.5 / 5.0), 1e-8) << "t of 4 degrees";
    EXPECT_NEAR(spread({0.0, 2.0}, 0.95).half_width, 12.70620474, 1e-7) << "t of 1";
    EXPECT_NEAR(spread({0.0, 2.0}, 0.90).half_width, 6.313751515, 1e-8);
}

TEST(Spread, OfOneOrNoneIsNotKnown) {
    EXPECT_DOUBLE_EQ(spread({7.0}, 0.95).mean, 7.0);
    EXPECT_TRUE(std::isnan(spread({7.0}, 0.95).half_width));
    EXPECT_TRUE(std::isnan(spread({}, 0.95).mean));
    EXPECT_FALSE(members_needed(spread({7.0}, 0.95), 0.01, 0.95));
    EXPECT_FALSE(members_needed(spread({-1.0, 1.0}, 0.95), 0.01, 0.95)) << "of a mean of zero";
    EXPECT_FALSE(members_needed(spread({1e-9, -2e-9, 3e-9}, 0.95), 1e-9, 0.95)) << "out of reach";
    EXPECT_THROW(spread({1.0, 2.0}, 1.0), InputError);
    EXPECT_THROW(spread({1.0, 2.0}, 0.0), InputError);
}

TEST(Spread, HoldsTheMeanAsOftenAsItSays) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> member(10.0, 3.0);
    constexpr int trials = 4000;
    int held = 0;
    for (int k = 0; k < trials; ++k) {
        const Spread found =
            spread({member(random), member(random), member(random), member(random)}, 0.9);
        if (std::abs(found.mean - 10.0) <= found.half_width) ++held;
    }
    // Four standard deviations of the count: sqrt(0.9 * 0.1 / 4000) = 0.0047. The normal
    // distribution in place of Student's would hold 0.80 of them.
    EXPECT_NEAR(double(held) / trials, 0.9, 4 * 0.0047);
}

TEST(Spread, SaysTheLeastNumberThatIsNeeded) {
    for (const double deviation : {0.001, 0.01, 0.05, 0.3})
        for (const double interval : {0.01, 0.05}) {
            const Spread found{3, 1.0, deviation, 0.0};
            const long count = members_needed(found, interval, 0.95).value();
            // By brute force, with t of the tables through spread() itself: two members a
            // deviation apart, scaled to it.
            const auto half_width = [&](long n) {
                std::vector<double> values(size_t(n), 0.0);
                for (size_t k = 0; k < values.size(); ++k) values[k] = k % 2 == 0 ? -1.0 : 1.0;
                const Spread unit = spread(values, 0.95);
                return unit.half_width / unit.standard_deviation * deviation;
            };
            EXPECT_LE(half_width(count), interval);
            if (count > 2) {
                EXPECT_GT(half_width(count - 1), interval);
            }
        }
}

EnsembleBurn burn(const std::string& key, double pressure, const std::string& seed, double v) {
    EnsembleBurn burn{.key = key,
                      .rest = std::to_string(pressure),
                      .conditions = {0.72, pressure, "paper", 16, 12, 8e-3, 4e-3},
                      .seed = seed,
                      .state = "done",
                      .reason = "",
                      .values = {v, 0.9 * v, 950.0, none}};
    return burn;
}

EnsembleBurn failed(const std::string& key, double pressure, const std::string& seed) {
    EnsembleBurn burn = reports::burn(key, pressure, seed, none);
    burn.state = "failed";
    burn.reason = "step 3: heat: T = -1 K, limit 0; \"reduce\" time.step";
    burn.values = {none, none, none, none};
    return burn;
}

TEST(Ensemble, MakesPointsOfLikeConditions) {
    const Ensemble found =
        gather({burn("e", 5e6, "2", 0.7), burn("b", 2e6, "10", 0.4), burn("a", 2e6, "9", 0.5),
                failed("c", 2e6, "11"), burn("d", 5e6, "1", 0.6), burn("a", 2e6, "9", 0.5)},
               {});
    ASSERT_EQ(found.burns.size(), 5U) << "a counts once";
    EXPECT_EQ(found.burns[0].seed, "9") << "seeds are numbers";
    ASSERT_EQ(found.points.size(), 2U);
    EXPECT_EQ(found.points[0].burns, 3);
    EXPECT_EQ(found.points[0].spreads[0].count, 2) << "what failed is no part of a mean";
    EXPECT_DOUBLE_EQ(found.points[0].spreads[0].mean, 0.45);
    EXPECT_DOUBLE_EQ(found.points[1].spreads[0].mean, 0.65);
    EXPECT_EQ(found.points[0].spreads[3].count, 0) << "no strain";
}

TEST(Ensemble, DoesNotDependOnTheOrderItIsFoundIn) {
    const std::vector<EnsembleBurn> burns{burn("a", 2e6, "1", 0.1), burn("b", 2e6, "2", 0.2),
                                          burn("c", 2e6, "3", 0.3), failed("d", 2e6, "4")};
    const Ensemble one = gather(burns, {});
    const Ensemble other = gather({burns.rbegin(), burns.rend()}, {});
    EXPECT_EQ(points_csv(one), points_csv(other));
    EXPECT_EQ(burns_csv(one), burns_csv(other));
    EXPECT_EQ(ensemble_json(one), ensemble_json(other));
}

TEST(Ensemble, TellsWhatFailedAndWhy) {
    const Ensemble found = gather({burn("a", 2e6, "1", 0.1), failed("d", 2e6, "4")}, {});
    const std::string csv = burns_csv(found);
    EXPECT_THAT(csv, HasSubstr("V [cm/s],mean burn rate [cm/s],max T [K],strain within 5 um [-]"));
    EXPECT_THAT(csv, HasSubstr("4,nan,nan,nan,nan,failed,"
                               "\"step 3: heat: T = -1 K, limit 0; \"\"reduce\"\" time.step\",d"));
    EXPECT_THAT(ensemble_json(found), HasSubstr("\"packs_needed\": null"));
    const std::string page = page::ensemble_page(found, {.title = "Packs <1>",
                                                         .pictures = {},
                                                         .tables = {"points.csv"},
                                                         .command = "crawford gather",
                                                         .revision = "abc",
                                                         .solvers = {"x", "y"},
                                                         .remarks = {"coarse, of 2 burns"}});
    EXPECT_THAT(page, HasSubstr("<h1>Packs &lt;1&gt;</h1>"));
    EXPECT_THAT(page, HasSubstr("1 of 2 burns done, 1 points"));
    EXPECT_THAT(page, HasSubstr("Burns that are not done"));
    EXPECT_THAT(page, HasSubstr("heat: T = -1 K, limit 0"));
    EXPECT_THAT(page, HasSubstr("2 different solvers"));
    EXPECT_THAT(page, HasSubstr("<li>coarse, of 2 burns</li>"));
}

}  // namespace
}  // namespace crawford::reports
