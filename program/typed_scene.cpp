#include "program/typed_scene.hpp"

#include <iostream>
#include <iterator>

#include "solver/scene/read_scene.hpp"

namespace crawford {

namespace {

namespace fs = std::filesystem;

constexpr auto standard_input = "-";

/// "morphology.file=table.csv" with the whole path of a table that lies here.
std::string from_here(const std::string& assignment) {
    const std::string key = "morphology.file=";
    if (!assignment.starts_with(key)) return assignment;
    const fs::path file = assignment.substr(key.size());
    return fs::is_regular_file(file) ? key + fs::absolute(file).string() : assignment;
}

}  // namespace

Scene typed_scene(const fs::path& file, const std::vector<std::string>& set) {
    std::vector<std::string> overrides;
    for (const std::string& assignment : set) overrides.push_back(from_here(assignment));
    if (file != standard_input) return read_scene(file, overrides);
    const std::string text(std::istreambuf_iterator<char>(std::cin), {});
    return parse_scene(text, fs::current_path(), overrides);
}

std::string name_of_scene(const fs::path& file) {
    return file == standard_input ? "scene" : file.stem().string();
}

}  // namespace crawford
