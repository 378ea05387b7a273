/// Where the sources lie: pages, scenes and scripts are read from there.
#pragma once

#include <filesystem>

namespace crawford {

/// `relative` below the source tree. Absolute paths are returned as they are.
std::filesystem::path source_path(const std::filesystem::path& relative);

/// The other way round: where a source file, such as __FILE__, lies in the tree.
std::filesystem::path place_in_source_tree(const std::filesystem::path& file);

}  // namespace crawford
