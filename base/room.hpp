/// Memory that a library needs and cannot do without.
#pragma once

#include <cstddef>

namespace crawford {

/// Looks for as much room in one piece, and leaves it free: for libraries that do not end well where they find none.
/// \throws std::bad_alloc if there is none.
void look_for_room(std::size_t bytes);

}  // namespace crawford
