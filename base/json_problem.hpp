/// What is wrong with a JSON file, for those who have to mend it.
#pragma once

#include <string>

namespace crawford {

/// `what` of an exception of the JSON library without the class and number in front: "parse error at
/// line 1, column 2: ...".
std::string json_problem(const std::string& what);

}  // namespace crawford
