#include "reports/norm.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace crawford::reports {
namespace {

constexpr double round_off = 1e-15;  // a few additions of numbers of size one

const std::vector<double> error{3.0, -4.0};
const std::vector<double> sizes{1.0, 3.0};

TEST(Norm, WeighsEachValueByTheCellItStandsFor) {
    EXPECT_NEAR(norm(Norm::L1, error, sizes), (3.0 + 3.0 * 4.0) / 4.0, round_off);
    EXPECT_NEAR(norm(Norm::L2, error, sizes), std::sqrt((9.0 + 3.0 * 16.0) / 4.0), round_off);
    EXPECT_EQ(norm(Norm::Linf, error, sizes), 4.0);
}

TEST(Norm, OfThePaperIsUnweighted) {
    EXPECT_NEAR(norm(Norm::paper, error, sizes), std::sqrt((9.0 + 16.0) / 2.0), round_off);
    EXPECT_NEAR(norm(Norm::paper, error), norm(Norm::L2, error), round_off);
}

TEST(Norm, DoesNotChangeWithTheUnitOfTheCellSize) {
    const std::vector<double> tiny{1e-12, 3e-12};
    EXPECT_NEAR(norm(Norm::L2, error, tiny), norm(Norm::L2, error, sizes), round_off);
}

TEST(Norm, OfAConstantFieldIsTheConstantOnAnyGrid) {
    const std::vector<double> field(3, -2.0), clustered{0.1, 0.2, 0.7};
    for (const Norm in : {Norm::L1, Norm::L2, Norm::Linf, Norm::paper})
        EXPECT_NEAR(norm(in, field, clustered), 2.0, round_off) << name(in);
}

TEST(Norm, PassesNaNOn) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Norm in : {Norm::L1, Norm::L2, Norm::Linf, Norm::paper})
        for (const auto& field :
             {std::vector{nan, 1.0, 2.0}, std::vector{1.0, nan, 2.0}, std::vector{1.0, 2.0, nan}})
            EXPECT_TRUE(std::isnan(norm(in, field))) << name(in);
    EXPECT_TRUE(std::isnan(norm(Norm::magnitude, std::vector{nan})));
}

TEST(Norm, RefusesWhatHasNoNorm) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(norm(Norm::L2, {}), std::invalid_argument);
    EXPECT_THROW(norm(Norm::L2, error, std::vector{1.0}), std::invalid_argument);
    EXPECT_THROW(norm(Norm::L2, error, std::vector{3.0, -1.0}), std::invalid_argument);
    EXPECT_THROW(norm(Norm::L2, error, std::vector{0.0, 0.0}), std::invalid_argument);
    EXPECT_THROW(norm(Norm::L2, error, std::vector{nan, 1.0}), std::invalid_argument);
    EXPECT_THROW(norm(Norm::magnitude, error), std::invalid_argument);
    EXPECT_THROW(distance(Norm::L2, error, std::vector{1.0}), std::invalid_argument);
}

TEST(Distance, IsTheNormOfTheDifference) {
    const std::vector<double> truth{1.0, 1.0};
    EXPECT_NEAR(distance(Norm::L1, error, truth, sizes), (2.0 + 3.0 * 5.0) / 4.0, round_off);
}

}  // namespace
}  // namespace crawford::reports
