/// A directory of a test's own, gone when the test is over.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "base/scratch.hpp"

namespace crawford {

class OutputTest : public ::testing::Test {
protected:
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

    const Scratch scratch;
    const std::filesystem::path directory = scratch.path();
};

}  // namespace crawford
