#include "base/room.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <new>

namespace crawford {
namespace {

TEST(Room, IsThereOrNot) {
    EXPECT_NO_THROW(look_for_room(1 << 20));
    EXPECT_THROW(look_for_room(std::numeric_limits<std::size_t>::max() / 2), std::bad_alloc);
}

}  // namespace
}  // namespace crawford
