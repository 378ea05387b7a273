/// Where the program under test lies.
#pragma once

#include <string>

namespace crawford {

std::string program_path();

/// The same program, but that everything in it burns 1 % too fast.
std::string altered_program_path();

}  // namespace crawford
