/// Short numbers for long texts.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace crawford {

/// SHA-1 of a text, as hexadecimal digits in groups: the same in every run and on every machine.
std::string digest(std::string_view text);

/// Of all files below a directory: their names and contents.
/// \throws InputError if one cannot be read.
std::string digest_of_files(const std::filesystem::path& directory);

}  // namespace crawford
