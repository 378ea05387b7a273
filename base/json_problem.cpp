#include "base/json_problem.hpp"

namespace crawford {

std::string json_problem(const std::string& what) {
    const auto end = what.find("] ");
    return what.starts_with("[json.exception") && end != std::string::npos ? what.substr(end + 2)
                                                                           : what;
}

}  // namespace crawford
