// Fronts of cost and error.
#include "reports/pareto.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace crawford::reports {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(ParetoFront, HoldsWhatNothingBeats) {
    EXPECT_THAT(pareto_front({{4.0, 1.0}, {1.0, 4.0}, {3.0, 3.0}, {2.0, 2.0}, {5.0, 1.0}}),
                ElementsAre(1, 3, 0));
}

TEST(ParetoFront, TakesTheFirstOfEquals) {
    EXPECT_THAT(pareto_front({{1.0, 1.0}, {1.0, 1.0}, {1.0, 0.5}}), ElementsAre(2));
    EXPECT_THAT(pareto_front({{1.0, 1.0}, {1.0, 1.0}}), ElementsAre(0));
}

TEST(ParetoFront, LeavesOutWhatIsNoNumber) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(pareto_front({{nan, 0.0}, {1.0, nan}}), IsEmpty());
    EXPECT_THAT(pareto_front({}), IsEmpty());
}

}  // namespace
}  // namespace crawford::reports
