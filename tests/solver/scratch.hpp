/// A directory of a test's own, gone when the test is over.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace crawford {

class OutputTest : public ::testing::Test {
protected:
    void SetUp() override {
        std::string path = std::filesystem::temp_directory_path() / "crawford-XXXXXX";
        ASSERT_NE(::mkdtemp(path.data()), nullptr);
        directory = path;
    }
    void TearDown() override { std::filesystem::remove_all(directory); }

    static std::string content(const std::filesystem::path& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    static void put(const std::filesystem::path& path, const std::string& text) {
        std::ofstream(path, std::ios::binary) << text;
    }
    /// The message of the Error that `call` throws.
    template <class Error, class Call>
    static std::string message_of(Call call) {
        try {
            call();
        } catch (const Error& error) {
            return error.what();
        }
        ADD_FAILURE() << "nothing was thrown";
        return {};
    }

    std::filesystem::path directory;
};

}  // namespace crawford
