/// Where the program under test lies.
#pragma once

#include <string>

namespace crawford {

std::string program_path();

}  // namespace crawford
