// A peak's mean is a number on any grid.
#include "solver/run/peak.hpp"

#include <gtest/gtest.h>

namespace crawford {
namespace {

TEST(Peak, OfADiscBetweenTheSamplesIsTheCells) {
    constexpr double cell = 200e-6;
    NodeVectors position(3, 3);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) position(i, j) = {cell * i, cell * j};
    CellField field(2, 2), material(2, 2);
    field(1, 1) = 0.5;
    const Peak found = peak(position, material, field, peak_radius);
    EXPECT_EQ(found.value, 0.5);
    EXPECT_EQ(found.mean, 0.5);
}

}  // namespace
}  // namespace crawford
