#include "tests/program_path.hpp"

namespace crawford {

std::string program_path() {
    return CRAWFORD_PROGRAM;
}

}  // namespace crawford
