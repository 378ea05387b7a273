#include "base/room.hpp"

#include <sys/mman.h>

#include <new>
#include <system_error>

namespace crawford {

void look_for_room(std::size_t bytes) {
    void* const room =
        ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (room == MAP_FAILED) throw std::bad_alloc();
    ::munmap(room, bytes);
}

bool is_out_of_memory(const std::exception_ptr& problem) {
    try {
        std::rethrow_exception(problem);
    } catch (const std::bad_alloc&) {
        return true;
    } catch (const std::system_error& error) {
        // A thread that finds no room for its stack.
        return error.code() == std::errc::resource_unavailable_try_again ||
               error.code() == std::errc::not_enough_memory;
    } catch (...) {
        return false;
    }
}

}  // namespace crawford
