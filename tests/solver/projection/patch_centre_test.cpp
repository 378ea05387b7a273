#include "solver/projection/patch_centre.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

namespace crawford {

namespace {

/// Symmetric and positive definite, every entry another.
PatchMatrix some_stiffness() {
    PatchMatrix k = 20.0 * PatchMatrix::Identity();
    for (int p = 0; p < 18; ++p)
        for (int q = 0; q < 18; ++q) k(p, q) += 1.0 / (1.0 + p + q);
    return k;
}

}  // namespace

TEST(PatchCentre, WhatIsLeftHasTheSolutionOfTheWhole) {
    const PatchMatrix whole = some_stiffness();
    PatchVector force;
    for (int p = 0; p < 18; ++p) force[p] = 1.0 + p * p;
    const PatchVector expected = whole.llt().solve(force);

    PatchMatrix left = whole;
    const PatchCentre centre(left);
    const Eigen::Vector2d on_centre = force.segment<2>(PatchCentre::first);
    PatchVector around_force = force + centre.spread(on_centre);
    around_force.segment<2>(PatchCentre::first).setZero();
    left.block<2, 2>(PatchCentre::first, PatchCentre::first).setIdentity();
    const PatchVector around = left.llt().solve(around_force);

    PatchVector found = around;
    found.segment<2>(PatchCentre::first) = centre.velocity(on_centre, around);
    EXPECT_LT((found - expected).norm(), 1e-13 * expected.norm());
}

}  // namespace crawford
