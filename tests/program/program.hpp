/// What tests of the built program share.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "base/scratch.hpp"
#include "base/source_tree.hpp"
#include "tests/program_path.hpp"

namespace crawford {

inline const std::string scenes = source_path("cases/scenes/").string();

inline Finished crawford(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), program_path());
    return run_program(arguments);
}

/// Refused as wrong input, in one line that contains `message`.
inline void expect_refused(const std::vector<std::string>& arguments, const std::string& message) {
    const Finished run = crawford(arguments);
    EXPECT_EQ(run.status, 2) << run.output;
    EXPECT_THAT(run.output, testing::HasSubstr(message));
    EXPECT_THAT(run.output, testing::StartsWith("crawford: "));
    EXPECT_EQ(std::ranges::count(run.output, '\n'), 1) << run.output;
}

/// The program, sent `signal` once the shell command `there` succeeds: a wait for what it writes,
/// not for a time, since a busy machine may take seconds to start it.
inline Finished signalled(const std::string& signal, const std::string& there,
                          const std::vector<std::string>& arguments) {
    std::vector<std::string> command{
        "sh", "-c",
        "\"$@\" & child=$!; until " + there +
            " >/dev/null 2>&1; do kill -0 $child || break; sleep 0.05; done; kill -" + signal +
            " $child; wait $child",
        "sh", program_path()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run_program(command);
}

/// A directory of the test's own, which does not exist yet.
class ProgramTest : public testing::Test {
protected:
    std::string out() const { return out_.string(); }

    const Scratch scratch_;
    const std::filesystem::path out_ = scratch_.path() / "out";
};

}  // namespace crawford
