/// What every truth does with points, times and parameters, whatever it is the truth of.
#include "reference/truth.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/errors.hpp"
#include "reference/truth_parameters.hpp"

namespace crawford::reference {

namespace {

using testing::HasSubstr;

template <class Error, class Action>
std::string message(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing was thrown";
}

/// log10(-y), under a surface that sinks, for a second.
Truth logarithm() {
    return {{{"logarithm", "1", "of the depth"}},
            {.x = {0.0, 2.0},
             .y = {-1.0, 0.0},
             .time = {0.0, 1.0},
             .surface = [](double, double t) { return -0.5 * t; }},
            [](std::span<const Eigen::Vector2d> points, double) {
                Eigen::MatrixXd table(static_cast<Eigen::Index>(points.size()), 1);
                for (size_t k = 0; k < points.size(); ++k)
                    table(static_cast<Eigen::Index>(k), 0) = std::log10(-points[k].y());
                return table;
            }};
}

template <class Error = InputError>
std::string refusal(double x, double y, double t) {
    return message<Error>([&] { logarithm().values(std::vector{Eigen::Vector2d(x, y)}, t); });
}

TEST(Truth, AnswersInTheOrderOfThePoints) {
    const std::vector<Eigen::Vector2d> points{{0.0, -0.1}, {1.0, -1.0}, {2.0, -0.01}};
    EXPECT_EQ(logarithm().values(points).column("logarithm"),
              (std::vector{std::log10(0.1), 0.0, std::log10(0.01)}));
    EXPECT_TRUE(logarithm().values({}).column("logarithm").empty());
}

TEST(Truth, NamesThePointThatIsOutside) {
    EXPECT_EQ(refusal(2.5, -0.5, 0.0), "point (2.5, -0.5) m: x must be from 0 to 2 m");
    EXPECT_EQ(refusal(1.0, -0.25, 1.0),
              "point (1, -0.25) m: y, counted from the surface at -0.5 m, must be from -1 to 0 m");
    EXPECT_EQ(refusal(1.0, -0.25, 2.0), "time = 2 s must be from 0 to 1 s");
    EXPECT_THAT(refusal(1.0, std::nan(""), 0.5), HasSubstr("y, counted from the surface"));
}

TEST(Truth, TakesAPointThatRoundingHasPutBeyondAnEdge) {
    EXPECT_NO_THROW(logarithm().values(std::vector{Eigen::Vector2d(-1e-13, -1.0 - 1e-13)}));
    EXPECT_THAT(refusal(-1e-11, -1.0, 0.0), HasSubstr("x must be"));
}

TEST(Truth, NeverTellsWhatIsNotFinite) {
    EXPECT_THAT(refusal<NumericalFailure>(1.0, 0.0, 0.0),
                "logarithm = -inf at point (1, 0) m, time = 0 s");
}

TEST(Truth, PassesOnWhatItsClassRefuses) {
    const Truth none({{"none", "1", "nothing"}}, {},
                     [](std::span<const Eigen::Vector2d>, double) -> Eigen::MatrixXd {
                         throw std::invalid_argument("no particle is here");
                     });
    EXPECT_EQ(message<InputError>([&] { none.values(std::vector<Eigen::Vector2d>(1)); }),
              "no particle is here");
}

const std::vector<Parameter>& parameters() {
    static const std::vector<Parameter> all{
        number("depth", "m", 1.0, limits::positive, "of the bottom"),
        number("share", "1", 0.5, {.from = 0.0, .to = 1.0}, "of the width"),
        number("degree", "1", 8.0, {.from = 1.0, .whole = true}, "of a polynomial"),
        number("height", "m", limits::infinity, limits::positive_or_infinite, "of the top"),
        text("support", "roller", {"roller", "clamped"}, "of the bottom"),
        {.name = "density",
         .unit = "kg/m^3",
         .meaning = "rho",
         .standard = {},
         .otherwise = "that of the material",
         .limits = limits::positive}};
    return all;
}

std::string refused(const Parameters& given) {
    return message<InputError>([&] { Given(parameters(), given); });
}

TEST(GivenParameters, AreCompletedByTheirStandards) {
    const Given given(parameters(), {{"share", 0.25}});
    EXPECT_EQ(given.number("share"), 0.25);
    EXPECT_EQ(given.number("depth"), 1.0);
    EXPECT_TRUE(std::isinf(given.number("height")));
    EXPECT_EQ(given.text("support"), "roller");
    EXPECT_EQ(given.number_or("density", 7.0), 7.0);
    EXPECT_EQ(Given(parameters(), {{"density", 3.0}}).number_or("density", 7.0), 3.0);
}

TEST(GivenParameters, AreRefusedWithValueUnitAndLimit) {
    EXPECT_EQ(refused({{"depth", -2.0}}), "depth = -2 m must be above 0 m");
    EXPECT_EQ(refused({{"depth", limits::infinity}}), "depth = inf m must be above 0 m");
    EXPECT_EQ(refused({{"share", 1.5}}), "share = 1.5 must be from 0 to 1");
    EXPECT_EQ(refused({{"degree", 2.5}}), "degree = 2.5 must be a whole number at least 1");
    EXPECT_EQ(refused({{"depth", "deep"}}), "depth = deep must be a number, above 0 m");
    EXPECT_EQ(refused({{"support", "rollers"}}),
              "support = rollers is unknown; did you mean roller?");
    EXPECT_EQ(refused({{"support", 2.0}}), "support = 2 must be a text; known: roller, clamped");
    EXPECT_EQ(refused({{"dept", 2.0}}), "unknown parameter dept; did you mean depth?");
}

TEST(GivenParameters, MayBeInfiniteWhereThatMeansSomething) {
    EXPECT_EQ(refused({{"height", limits::infinity}}), "nothing was thrown");
    EXPECT_THAT(refused({{"height", -limits::infinity}}), HasSubstr("must be above 0 m"));
}

}  // namespace

}  // namespace crawford::reference
