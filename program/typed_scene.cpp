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

std::vector<std::string> from_here(const std::vector<std::string>& set) {
    std::vector<std::string> overrides;
    for (const std::string& assignment : set) overrides.push_back(from_here(assignment));
    return overrides;
}

using Overrides = std::vector<std::string>;

/// Reads the scene however often it is asked for; standard input comes but once.
std::function<Scene(const Overrides&)> reader_of(const fs::path& file) {
    if (file != standard_input)
        return [file](const Overrides& overrides) { return read_scene(file, overrides); };
    const std::string text(std::istreambuf_iterator<char>(std::cin), {});
    return [text](const Overrides& overrides) {
        return parse_scene(text, fs::current_path(), overrides);
    };
}

}  // namespace

Scene typed_scene(const fs::path& file, const std::vector<std::string>& set) {
    return reader_of(file)(from_here(set));
}

Scene typed_scene(const fs::path& file, const std::vector<std::string>& set,
                  const std::function<std::vector<std::string>(const Scene&)>& chosen) {
    const auto read = reader_of(file);
    const Overrides own = from_here(set);
    Overrides overrides = chosen(read(own));
    overrides.insert(overrides.end(), own.begin(), own.end());
    return read(overrides);
}

std::string name_of_scene(const fs::path& file) {
    return file == standard_input ? "scene" : file.stem().string();
}

}  // namespace crawford
