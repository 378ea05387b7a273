/// Too little memory: looked for beforehand, and known afterwards.
#pragma once

#include <cstddef>
#include <exception>

namespace crawford {

/// More than a library wants as it starts, with some for what other threads take in between: HDF5's tables and the cache of a file
/// are 1.7 MB, udunits2's database and scanner less.
constexpr std::size_t for_a_library = 16 << 20;

/// Looks for as much room in one piece, and leaves it free: for libraries that do not end well where they find none.
/// \throws std::bad_alloc if there is none.
void look_for_room(std::size_t bytes);

/// Whether it says that there was no memory, or no room for a thread.
bool is_out_of_memory(const std::exception_ptr& problem);

}  // namespace crawford
