#include "base/whole_number.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace crawford {
namespace {

using Json = nlohmann::json;

TEST(WholeNumber, IsReadAsItStandsThere) {
    EXPECT_EQ(whole_number<int>(Json(-7)), -7);
    EXPECT_EQ(whole_number<std::uint64_t>(Json(std::numeric_limits<std::uint64_t>::max())),
              std::numeric_limits<std::uint64_t>::max());
    EXPECT_EQ(whole_numbers<int>(Json{32, 64}), (std::vector{32, 64}));
}

TEST(WholeNumber, IsRefusedWhereItWouldBeAnother) {
    for (const Json& other : {Json(3.7), Json(3.4e86), Json(true), Json("3"), Json(nullptr),
                              Json(std::int64_t{1} << 40), Json(std::uint64_t{1} << 63)})
        EXPECT_THROW(whole_number<int>(other), Json::type_error) << other;
    EXPECT_THROW(whole_number<unsigned>(Json(-1)), Json::type_error);
    EXPECT_THROW(whole_numbers<int>(Json{{"32", 64}}), Json::type_error);
}

}  // namespace
}  // namespace crawford
