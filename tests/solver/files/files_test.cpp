// Whole files or none, and HDF5 without its chatter.

#include <cstdint>
#include <cstring>
#include <vector>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "solver/files/hdf5_file.hpp"
#include "tests/solver/scratch.hpp"

namespace crawford {

namespace {

using ::testing::internal::CaptureStderr;
using ::testing::internal::GetCapturedStderr;

class OutputFiles : public OutputTest {};

TEST_F(OutputFiles, AnUnpublishedFileLeavesTheOldOneAndNothingElse) {
    put(directory / "result", "old");
    {
        AtomicFile pending(directory / "result");
        put(pending.temporary(), "half a resu");
    }
    EXPECT_EQ(content(directory / "result"), "old");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory), {}), 1);
}

TEST_F(OutputFiles, APublishedFileReplacesTheOldOne) {
    put(directory / "result", "old");
    write_file(directory / "result", "new");
    EXPECT_EQ(content(directory / "result"), "new");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory), {}), 1);
}

TEST_F(OutputFiles, ADirectoryIsMadeWithItsParents) {
    prepare_directory(directory / "a" / "b");
    EXPECT_TRUE(std::filesystem::is_directory(directory / "a" / "b"));
    EXPECT_TRUE(std::filesystem::is_empty(directory / "a" / "b"));
}

TEST_F(OutputFiles, WhatCannotBeADirectoryIsRefusedByName) {
    put(directory / "file", "");
    const auto message =
        message_of<InputError>([&] { prepare_directory(directory / "file" / "out"); });
    EXPECT_NE(message.find("file/out: Not a directory"), std::string::npos) << message;
}

// /proc takes no files, not even from root, for whom permissions mean nothing.
TEST_F(OutputFiles, ADirectoryThatTakesNoFilesIsRefused) {
    EXPECT_THROW(prepare_directory("/proc"), InputError);
}

TEST_F(OutputFiles, Hdf5KeepsNumbersShapesAndLongTexts) {
    const std::vector<double> numbers = {0.1, -0.0, 1e-310, 6.02e23, 1.0 / 3.0, 2.0};
    const std::vector<std::int64_t> integers = {-1, 1L << 60};
    const std::string text(200'000, 'x');  // three times what HDF5 takes in a compact attribute
    Hdf5File file = Hdf5File::create(directory / "f.h5");
    file.create_group("/g");
    file.write("/g/numbers", std::span(numbers), {2, 3}, "Pa");
    file.write("/g/integers", std::span(integers), {2}, "1");
    file.set_attribute("/g", "text", text);
    file.publish();

    const Hdf5File read = Hdf5File::open(directory / "f.h5");
    EXPECT_EQ(read.shape("/g/numbers"), (Hdf5File::Shape{2, 3}));
    const auto back = read.read<double>("/g/numbers");
    EXPECT_EQ(0, std::memcmp(back.data(), numbers.data(), sizeof(double) * numbers.size()));
    EXPECT_EQ(read.read<std::int64_t>("/g/integers"), integers);
    EXPECT_EQ(read.text_attribute("/g", "text"), text);
    EXPECT_EQ(read.text_attribute("/g/numbers", "units"), "Pa");
    EXPECT_TRUE(read.contains("/g/numbers"));
    EXPECT_FALSE(read.contains("/g/nothing"));
    EXPECT_FALSE(read.contains("/nothing/numbers"));
}

TEST_F(OutputFiles, Hdf5SaysWhyInOneLineAndPrintsNothing) {
    put(directory / "text.h5", "no HDF5 at all");
    CaptureStderr();
    const auto missing = message_of<InputError>([&] { Hdf5File::open(directory / "missing.h5"); });
    const auto foreign = message_of<InputError>([&] { Hdf5File::open(directory / "text.h5"); });
    const auto nowhere =
        message_of<InputError>([&] { Hdf5File::create(directory / "text.h5" / "f.h5").publish(); });
    EXPECT_EQ(GetCapturedStderr(), "");
    EXPECT_NE(missing.find("missing.h5: No such file"), std::string::npos) << missing;
    EXPECT_NE(foreign.find("text.h5: "), std::string::npos) << foreign;
    EXPECT_NE(nowhere.find("cannot write"), std::string::npos) << nowhere;
}

TEST_F(OutputFiles, NumbersThatDoNotFillTheirShapeAreAnError) {
    const std::vector<double> numbers(5);
    Hdf5File file = Hdf5File::create(directory / "f.h5");
    EXPECT_THROW(file.write("/numbers", std::span(numbers), {2, 3}, "1"), std::invalid_argument);
}

}  // namespace

}  // namespace crawford
