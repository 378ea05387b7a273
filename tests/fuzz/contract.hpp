/// What every reader promises: any bytes give an answer or an InputError.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "base/errors.hpp"
#include "base/scratch.hpp"

namespace crawford::fuzz {

/// Calls `read`. Whatever else it throws ends the program, which is a finding.
template <class Read>
void must_answer(Read read) {
    try {
        read();
    } catch (const InputError&) {  // NOLINT(bugprone-empty-catch): the other good ending
    }
}

inline std::string_view text_of(const std::uint8_t* bytes, std::size_t size) {
    return {reinterpret_cast<const char*>(bytes), size};
}

/// A file with these bytes, the same one at each call: what it held before is gone.
inline std::filesystem::path file_of(const std::uint8_t* bytes, std::size_t size,
                                     const char* name) {
    static const Scratch scratch;
    auto path = scratch.path() / name;
    std::ofstream(path, std::ios::binary) << text_of(bytes, size);
    return path;
}

}  // namespace crawford::fuzz
