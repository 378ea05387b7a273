/// Every command that README and docs print runs as printed, from the root of the tree: those in
/// blocks of shell and those amid the text.
///
/// They run in a scratch root that links to the tree, where `build/crawford`, `make` and `ctest`
/// are stand_in.sh: it makes long commands short, and says how.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "base/scratch.hpp"
#include "base/source_tree.hpp"

namespace crawford {
namespace {

namespace fs = std::filesystem;

struct Printed {
    std::string where;
    std::string commands;  ///< for sh
};

std::string content(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Blocks of shell, and `build/crawford ...` and `make ...` amid text.
std::vector<Printed> commands_of(const fs::path& file) {
    static const std::regex printed(
        "```sh\n([^`]*(?:`(?!``)[^`]*)*)```|`((?:build/crawford|make) [^`\n]+)`");
    const std::string text = content(file);
    std::vector<Printed> all;
    for (std::sregex_iterator at(text.begin(), text.end(), printed), end; at != end; ++at)
        all.push_back({file.filename().string(), (*at)[1].matched ? (*at)[1] : (*at)[2]});
    return all;
}

/// README first: what it leaves in out/ others go on from.
std::vector<fs::path> documents() {
    std::vector<fs::path> documents;
    for (const auto& entry : fs::directory_iterator(source_path("docs")))
        if (entry.path().extension() == ".md") documents.push_back(entry.path());
    std::ranges::sort(documents);
    documents.insert(documents.begin(), source_path("README.md"));
    return documents;
}

class PrintedCommands : public testing::Test {
protected:
    PrintedCommands() {
        for (const char* directory : {"build", "bin", "refused"})
            fs::create_directories(root_ / directory);
        for (const char* name : {"cases", "docs", "examples", "results"})
            fs::create_directory_symlink(source_path(name), root_ / name);
        fs::create_directory_symlink(source_path("cases"), root_ / "refused" / "cases");
        for (const char* name : {"out", "DIR"})
            std::ofstream(root_ / "refused" / name) << "no directory";
        const auto stand_in = source_path("tests/printed/stand_in.sh");
        fs::create_symlink(stand_in, root_ / "build" / "crawford");
        fs::create_symlink(stand_in, root_ / "bin" / "make");
        fs::create_symlink(stand_in, root_ / "bin" / "ctest");
    }

    Finished run(const std::string& commands) const {
        const char* path = std::getenv("PATH");
        return run_program(
            {"env", "-C", root_.string(), fmt::format("PROGRAM={}", CRAWFORD_PROGRAM),
             fmt::format("TREE={}", source_path("").string()), fmt::format("REST={}", path),
             fmt::format("PATH={}/bin:{}", root_.string(), path), "sh", "-euc", commands});
    }

    Scratch scratch_;
    fs::path root_ = scratch_.path();
};

TEST_F(PrintedCommands, RunAsPrinted) {
    int count = 0;
    for (const fs::path& document : documents())
        for (const Printed& printed : commands_of(document)) {
            const Finished done = run(printed.commands);
            EXPECT_EQ(done.status, 0) << printed.where << ":\n"
                                      << printed.commands << "\n"
                                      << done.output;
            ++count;
        }
    EXPECT_GT(count, 15) << "are they still found?";
    EXPECT_THAT(content(root_ / "out/sandwich/manifest.json"),
                testing::HasSubstr("\"last_step\": 6000"))
        << "the example of a restart goes on, to 0.12 s";
}

TEST_F(PrintedCommands, AreRefusedWhereTheyAreWrong) {
    for (const char* wrong :
         {"build/crawford burn sandwich.toml", "build/crawford run fig3 --movie",
          "build/crawford verify slab --grid 32", "build/crawford verify no-such-study",
          "build/crawford burn cases/scenes/sandwich.toml --set surface.presure='4 MPa'",
          "make no-such-target"})
        EXPECT_NE(run(wrong).status, 0) << wrong;
}

}  // namespace
}  // namespace crawford
