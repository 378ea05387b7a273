/// Where the sources lie: pages, scenes and scripts are read from there.
#pragma once

#include <filesystem>

namespace crawford {

/// `relative` below the source tree. Absolute paths are returned as they are.
std::filesystem::path source_path(const std::filesystem::path& relative);

}  // namespace crawford
