// A failure of the numbers is fields, and one line made of them.
#include "base/errors.hpp"

#include <gtest/gtest.h>

namespace crawford {

namespace {

using Kind = FailureFields::Kind;

FailureFields coupling() {
    return {.kind = Kind::beyond_limit,
            .module = "heat",
            .quantity = "coupling number g",
            .value = 1.01449,
            .limit = FailureLimit{.value = 1.0, .condition = "for numerics.coupling = \"lagged\""},
            .place = FailurePlace{"cell", 0, 23},
            .step = 13,
            .time = 0.00104,
            .advice = "take \"adiabatic\""};
}

TEST(NumericalFailure, IsOneLine) {
    const NumericalFailure failure(coupling());
    EXPECT_STREQ(failure.what(),
                 "step 13 (t = 0.00104 s): heat: coupling number g = 1.014 at cell (0, 23), "
                 "limit 1 for numerics.coupling = \"lagged\"; take \"adiabatic\"");
    EXPECT_EQ(failure.fields().value, 1.01449);
    EXPECT_EQ(failure.fields().place->j, 23);
}

TEST(NumericalFailure, LeavesOutWhatDoesNotApply) {
    EXPECT_EQ(in_words({.kind = Kind::not_finite,
                        .module = "burning",
                        .quantity = "the surface",
                        .place = FailurePlace{"node column", 5}}),
              "burning: the surface is not a number at node column 5");
    EXPECT_EQ(in_words({.kind = Kind::not_positive_definite,
                        .module = "linear solver",
                        .quantity = "the matrix"}),
              "linear solver: the matrix is not positive definite");
    EXPECT_EQ(in_words({.kind = Kind::no_convergence,
                        .module = "linear solver",
                        .quantity = "relative residual after 70 iterations",
                        .value = 0.25,
                        .limit = FailureLimit{.value = 1e-8}}),
              "linear solver: no convergence: relative residual after 70 iterations = 0.25, limit "
              "1e-08");
    EXPECT_EQ(in_words({.kind = Kind::beyond_limit,
                        .module = "heat",
                        .quantity = "temperature",
                        .value = -3.0,
                        .unit = "K",
                        .limit = FailureLimit{.value = 0.0, .is_least = true}}),
              "heat: temperature = -3 K, limit above 0 K");
}

TEST(NumericalFailure, KeepsItsFieldsWhereAdviceIsAdded) {
    const NumericalFailure failure = with_advice(NumericalFailure(coupling()), "see there");
    EXPECT_EQ(failure.fields().advice, "take \"adiabatic\"; see there");
    EXPECT_EQ(failure.fields().kind, Kind::beyond_limit);
}

TEST(NumericalFailure, ThatWasToldIsItsMessage) {
    EXPECT_STREQ(NumericalFailure("not steady").what(), "not steady");
    EXPECT_EQ(name_of(NumericalFailure("not steady").fields().kind), "told");
}

}  // namespace

}  // namespace crawford
