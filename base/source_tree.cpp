#include "base/source_tree.hpp"

namespace crawford {

std::filesystem::path source_path(const std::filesystem::path& relative) {
    return std::filesystem::path(CRAWFORD_SOURCE_DIR) / relative;
}

}  // namespace crawford
