/// Orders of values without a truth: read where there is one, refused where there is none.
#include "reports/value_order.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace crawford::reports {
namespace {

using testing::HasSubstr;

ValueConvergence listed(const std::vector<double>& h, const std::vector<double>& values) {
    std::vector<ValueLevel> levels;
    for (std::size_t i = 0; i < h.size(); ++i)
        levels.push_back({static_cast<int>(i) + 1, h[i], values[i]});
    return ValueConvergence(levels);
}

ValueConvergence of(const std::function<double(double)>& u,
                    const std::vector<double>& h = {0.5, 0.3, 0.2, 0.12, 0.05}) {
    std::vector<double> values;
    for (const double size : h) values.push_back(u(size));
    return listed(h, values);
}

GateResult judged(const ValueConvergence& values, double order = 2.0) {
    return judge(Gate{"u", Norm::magnitude, expect(order).within(0.1), "a test"}, values);
}

TEST(ValueOrder, IsReadOnAnyRefinementRatios) {
    for (const double p : {0.3, 0.5, 1.0, 2.0, 3.7}) {
        const auto values = of([&](double h) { return 5.0 - 3.0 * std::pow(h, p); });
        EXPECT_NEAR(values.fit(), p, 1e-9);
        for (const double observed : values.pairwise()) EXPECT_NEAR(observed, p, 1e-9);
        EXPECT_EQ(values.verdict(), Verdict::monotone);
        EXPECT_TRUE(judged(values, p).passed);
        EXPECT_FALSE(judged(values, p + 0.2).passed);
    }
}

TEST(ValueOrder, OfOneRatioIsTheSlopeOfTheDifferences) {
    const std::vector<double> h{0.4, 0.2, 0.1, 0.05}, u{1.0, 1.3, 1.37, 1.386};
    std::vector<Level> differences;
    for (int i = 0; i < 3; ++i)
        differences.push_back(
            {i, h[static_cast<std::size_t>(i)],
             u[static_cast<std::size_t>(i) + 1] - u[static_cast<std::size_t>(i)]});
    EXPECT_NEAR(listed(h, u).fit(), from_differences(differences).fit(), 1e-12);
}

TEST(ValueOrder, NeverPassesWhatShowsNone) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> h{0.4, 0.2, 0.1, 0.05};
    EXPECT_THAT(judged(listed({0.4, 0.2}, {1.0, 1.1})).failure, HasSubstr("2 of at least 3"));
    EXPECT_THAT(judged(listed(h, {1.0, nan, 1.1, 1.2})).failure, HasSubstr("value is nan"));
    EXPECT_THAT(judged(listed(h, {1.0, 1.0, 1.0, 1.0})).failure, HasSubstr("round-off"));
    EXPECT_THAT(judged(listed(h, {1.0, 1.0 + 4e-14, 1.0 + 5e-14, 1.0 + 5.25e-14})).failure,
                HasSubstr("round-off"));
    EXPECT_THAT(judged(listed({0.4, 0.2, 0.2}, {1.0, 1.3, 1.4})).failure,
                HasSubstr("same cell size"));
    EXPECT_THAT(judged(listed(h, {1.0, 1.4, 1.3, 1.325})).failure, HasSubstr("oscillating"));
    EXPECT_THAT(judged(listed(h, {1.0, 1.1, 1.5, 3.1})).failure, HasSubstr("diverging"));
    EXPECT_THAT(judged(of([](double x) { return std::pow(x, 4.0); })).failure,
                HasSubstr("order 4.000 is outside"));
    EXPECT_THAT(judged(listed(h, {0.0, 1.0, 1.1, 1.125})).failure, HasSubstr("not asymptotic"));
}

TEST(ValueOrder, IsJudgedWithinTheRangeOfItsGate) {
    const auto values = listed({0.8, 0.4, 0.2, 0.1}, {9.0, 1.16, 1.04, 1.01});
    EXPECT_FALSE(judged(values).passed);
    const Gate gate{"u", Norm::magnitude, expect(2.0).within(0.1).from(2), "a test"};
    EXPECT_TRUE(judge(gate, values).passed);
}

}  // namespace
}  // namespace crawford::reports
