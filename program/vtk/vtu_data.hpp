/// The numbers of a data array of a VTU file, in whichever form it holds them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace crawford::vtk {

/// How a VTU file writes all of its binary data.
struct Encoding {
    bool is_big_endian = false;
    std::size_t header_bytes = 4;  ///< of a number of a block's header
    bool is_compressed = false;    ///< by zlib, in blocks
};

/// Numbers in text.
/// \throws InputError if something else stands there
std::vector<double> numbers_in_text(std::string_view text);

/// The bytes that base64 text stands for, of one piece or of several that follow each other.
/// \param most as many at least are decoded, if there are so many
/// \throws InputError if a letter is none of its alphabet
std::string from_base64(std::string_view text, std::size_t most);

/// The bytes of one array, its header taken off and its blocks unpacked. `encoded` begins with the header
/// and may go on beyond its end.
/// \throws InputError if it ends too early or a block is broken
std::string unpacked(std::string_view encoded, const Encoding& encoding, bool is_base64);

/// Bytes of numbers of VTK's type: "Float64", "Int32", ...
/// \throws InputError for another type
std::vector<double> numbers_of(std::string_view bytes, const std::string& type, bool is_big_endian);

}  // namespace crawford::vtk
