/// A scene as it is asked for on the command line.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "solver/scene/scene.hpp"

namespace crawford {

/// Reads `file`, or standard input where it is "-", with `set` put in ("dotted.key=value"). A table
/// of discs that is set lies where the user is, if it is there; else, as in the file, beside the
/// scene.
/// \throws InputError as read_scene
Scene typed_scene(const std::filesystem::path& file, const std::vector<std::string>& set);

/// The same with what `chosen` says of the scene put in as well; what is set wins.
Scene typed_scene(const std::filesystem::path& file, const std::vector<std::string>& set,
                  const std::function<std::vector<std::string>(const Scene&)>& chosen);

/// What the results of a scene are called: the file's name without its ending, "scene" where it came
/// in by standard input.
std::string name_of_scene(const std::filesystem::path& file);

}  // namespace crawford
