// Digests of files that a study reads: a change of any must be seen.
#include "base/digest.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "base/scratch.hpp"

namespace crawford {
namespace {

TEST(DigestOfFiles, ChangesWithNamesAndContentsAlone) {
    const Scratch scratch;
    const std::filesystem::path folder = scratch.path() / "scenes";
    std::filesystem::create_directories(folder / "presets");
    std::set<std::string> seen{digest_of_files(folder)};
    const auto changed = [&] { return seen.insert(digest_of_files(folder)).second; };
    EXPECT_FALSE(changed());
    std::ofstream(folder / "presets" / "draft.toml") << "error = 0.01";
    EXPECT_TRUE(changed());
    std::ofstream(folder / "presets" / "draft.toml") << "error = 0.02";
    EXPECT_TRUE(changed());
    EXPECT_FALSE(changed());
    std::filesystem::rename(folder / "presets" / "draft.toml", folder / "draft.toml");
    EXPECT_TRUE(changed());
}

}  // namespace
}  // namespace crawford
