// Units: the calorie of the combustion literature, the spellings of exponents, dimensions.
#include "solver/scene/units.hpp"

#include <gtest/gtest.h>

#include <future>
#include <vector>

#include "base/errors.hpp"

namespace crawford {

TEST(Units, TheCalorieIsThermochemical) {
    EXPECT_DOUBLE_EQ(read_quantity("1 cal", "J"), 4.184);  // udunits2 alone: 4.1868
    EXPECT_DOUBLE_EQ(read_quantity("1 kcal", "J"), 4184.0);
    EXPECT_DOUBLE_EQ(read_quantity("1 calorie", "J"), 4.184);
    EXPECT_DOUBLE_EQ(read_quantity("3 calories", "J"), 12.552);
}

TEST(Units, ExponentsAndQuotientsInAllSpellings) {
    for (const char* flux : {"200 cal/(s cm2)", "200 cal/(s cm^2)", "200 cal s-1 cm-2",
                             "200cal/s/cm2", "  200  cal/(cm2 s) ", "+2e2 cal/(s cm2)"}) {
        EXPECT_DOUBLE_EQ(read_quantity(flux, "W/m2"), 8.368e6) << flux;
    }
    EXPECT_DOUBLE_EQ(read_quantity("1e-5 1/K", "1/K"), 1e-5);
    EXPECT_DOUBLE_EQ(read_quantity("1e-5 /K", "1/K"), 1e-5);
    EXPECT_DOUBLE_EQ(read_quantity("1e-5 K-1", "1/K"), 1e-5);
    EXPECT_DOUBLE_EQ(read_quantity("0.45 cm/s", "m/s"), 4.5e-3);
}

TEST(Units, TemperaturesMayHaveAnotherZero) {
    EXPECT_NEAR(read_quantity("26.85 degC", "K"), 300.0, 1e-12);
}

TEST(Units, SiStaysExactToTheLastBit) {
    // Scene texts rely on it: a number written in SI must be read as the same double.
    for (const double value : {0.1, 1.0 / 3.0, 2.4e-4, 8.368e6}) {
        EXPECT_EQ(read_quantity(std::to_string(value) + " m", "m"),
                  std::stod(std::to_string(value)));
    }
    EXPECT_EQ(read_quantity("0.30000000000000004 W/(m K)", "W/(m K)"), 0.1 + 0.2);
}

TEST(Units, RefusesWhatIsNoQuantityOfThisDimension) {
    for (const char* wrong :
         {"", "MPa", "2", "2 K", "2 m", "2 nonsense", "nan Pa", "inf Pa", "-inf Pa", "1e999 Pa",
          "2 Pa since 2000-01-01", "2 (Pa", "2,5 MPa", "0x10 Pa", "1 1/Pa"}) {
        EXPECT_THROW(read_quantity(wrong, "Pa"), InputError) << wrong;
    }
    EXPECT_THROW(read_quantity("3 Hz", "s"), InputError) << "a reciprocal is another dimension";
}

TEST(Units, IsOneNumberThenOneUnit) {
    for (const char* wrong :
         {"1 200 kPa", "2.5.3 MPa", "2 1/2 MPa", "2 MPa since 1", "2 MPa from 1", "2 MPa after 1",
          "2 MPa ref 1", "2 MPa @ 10", "2 MPa SINCE 1", "2 /2 MPa", "2 (3 MPa)", "2 MPa 3",
          "2 MPa*3", "2 MPa -1", "1 2e3 Pa", "2 MPa.5"})
        EXPECT_THROW(read_quantity(wrong, "Pa"), InputError) << wrong;
    for (const char* wrong : {"300 K @ 10", "2 7 degC", "300 K since 1"})
        EXPECT_THROW(read_quantity(wrong, "K"), InputError) << wrong;
    EXPECT_EQ(read_quantity("2 m s-1", "m/s"), 2.0);
    EXPECT_EQ(read_quantity("2 kg m^-1 s**-2", "Pa"), 2.0);
    EXPECT_EQ(read_quantity("2 1/K", "K-1"), 2.0);
}

TEST(Units, SaysNothingOnStandardError) {
    testing::internal::CaptureStderr();
    EXPECT_THROW(read_quantity("2 (Pa", "Pa"), InputError);
    EXPECT_THROW(read_quantity("2 K", "Pa"), InputError);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Units, CanBeReadFromSeveralThreads) {
    // Grids of a study run side by side and each reads its scene: without a lock the scanner aborts
    // the program.
    std::vector<std::future<double>> sums;
    for (int thread = 0; thread < 4; ++thread) {
        sums.push_back(std::async(std::launch::async, [] {
            double sum = 0.0;
            for (int k = 0; k < 2000; ++k) sum += read_quantity("2 cal/(s cm2)", "W/m2");
            return sum;
        }));
    }
    for (auto& sum : sums) EXPECT_NEAR(sum.get(), 2000 * 2 * 41840.0, 1e-3);
}

}  // namespace crawford
