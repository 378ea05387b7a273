#include "tests/program_path.hpp"

namespace crawford {

std::string program_path() {
    return CRAWFORD_PROGRAM;
}

std::string altered_program_path() {
    return CRAWFORD_ALTERED_PROGRAM;
}

}  // namespace crawford
