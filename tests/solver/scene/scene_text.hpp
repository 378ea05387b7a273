/// A scene as text, and files beside it, that tests of the scene reader start from.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/scratch.hpp"
#include "solver/scene/read_scene.hpp"

namespace crawford::testing {

inline const std::string sandwich_toml = R"toml(title = "a sandwich"
[domain]
width = "240 um"
depth = "480 um"
nx = 64
ny = 96
[morphology]
kind = "sandwich"
strip = "60 um"
[surface]
pressure = "2 MPa"
heat_flux = { AP = "200 cal/(s cm2)", binder = "160 cal/(s cm2)" }
[time]
step = "20 us"
end = "0.1 s"
)toml";

/// Two discs in its place, as an override.
inline const std::vector<std::string> discs{
    "morphology={kind='discs', particle='AP', matrix='binder', "
    "period='480 um', discs=[{x='50 um', y='-50 um', radius='40 um'}, "
    "{x='150 um', y='-60 um', radius='30 um'}]}"};

/// The scene above with `overrides`.
inline Scene with(const std::vector<std::string>& overrides) {
    return parse_scene(sandwich_toml, ".", overrides);
}

/// `text` with the first `what` in it replaced.
inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const auto at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

/// A file in a folder of its own, removed with it.
class ScratchFile {
public:
    ScratchFile(const std::string& name, const std::string& content)
        : path_(scratch_.path() / name) {
        std::ofstream(path_) << content;
    }
    const std::filesystem::path& path() const { return path_; }

private:
    Scratch scratch_;
    std::filesystem::path path_;
};

}  // namespace crawford::testing
