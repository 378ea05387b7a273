/// One point of a truth, as its common face tells it, for tests that hold it against its class.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reference/plane_strain_stress.hpp"
#include "reference/truth_registry.hpp"

namespace crawford::reference {

inline constexpr double x = 31e-6;
inline constexpr double y = -47e-6;
inline constexpr double t = 2e-3;

/// One point of a truth.
class At {
public:
    explicit At(const char* name, const Parameters& given = {})
        : table_(truth(name, given).values(std::vector{Eigen::Vector2d(x, y)}, t)) {}

    double operator()(const char* field) const { return table_.column(field).front(); }

    void expect(const char* vector, const Eigen::Vector2d& wanted) const {
        EXPECT_EQ((*this)((std::string(vector) + "_x").c_str()), wanted.x()) << vector;
        EXPECT_EQ((*this)((std::string(vector) + "_y").c_str()), wanted.y()) << vector;
    }
    void expect_stress(const PlaneStrainStress& wanted) const {
        EXPECT_EQ((*this)("stress_xx"), wanted.xx);
        EXPECT_EQ((*this)("stress_yy"), wanted.yy);
        EXPECT_EQ((*this)("stress_zz"), wanted.zz);
        EXPECT_EQ((*this)("stress_xy"), wanted.xy);
        EXPECT_EQ((*this)("pressure"), wanted.pressure());
    }
    void expect_matrix(const std::string& name, const Eigen::Matrix2d& wanted) const {
        EXPECT_EQ((*this)((name + "_xx").c_str()), wanted(0, 0)) << name;
        EXPECT_EQ((*this)((name + "_xy").c_str()), wanted(0, 1)) << name;
        EXPECT_EQ((*this)((name + "_yx").c_str()), wanted(1, 0)) << name;
        EXPECT_EQ((*this)((name + "_yy").c_str()), wanted(1, 1)) << name;
    }
    void expect_symmetric(const std::string& name, const Eigen::Matrix2d& wanted) const {
        EXPECT_EQ((*this)((name + "_xx").c_str()), wanted(0, 0)) << name;
        EXPECT_EQ((*this)((name + "_yy").c_str()), wanted(1, 1)) << name;
        EXPECT_EQ((*this)((name + "_xy").c_str()), wanted(0, 1)) << name;
    }

private:
    FieldTable table_;
};

}  // namespace crawford::reference
