#include "base/source_tree.hpp"

namespace crawford {

std::filesystem::path source_path(const std::filesystem::path& relative) {
    return std::filesystem::path(CRAWFORD_SOURCE_DIR) / relative;
}

std::filesystem::path place_in_source_tree(const std::filesystem::path& file) {
    if (file.is_absolute()) return file.lexically_relative(CRAWFORD_SOURCE_DIR);
    // The compiler was called in a directory for builds somewhere below the tree.
    std::filesystem::path place;
    for (const auto& part : file)
        if (part != "..") place /= part;
    return place;
}

}  // namespace crawford
