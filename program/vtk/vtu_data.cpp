#include "program/vtk/vtu_data.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>

#include "base/errors.hpp"

namespace crawford::vtk {

namespace {

constexpr std::size_t everything = std::string::npos;

template <class Number>
Number number_at(std::string_view bytes, std::size_t at, bool is_big_endian) {
    std::string own(bytes.substr(at, sizeof(Number)));
    if (is_big_endian) std::ranges::reverse(own);  // this program runs on little-endian machines
    Number number{};
    std::memcpy(&number, own.data(), sizeof(Number));
    return number;
}

template <class Number>
std::vector<double> numbers(std::string_view bytes, bool is_big_endian) {
    std::vector<double> values;
    for (std::size_t at = 0; at + sizeof(Number) <= bytes.size(); at += sizeof(Number))
        values.push_back(double(number_at<Number>(bytes, at, is_big_endian)));
    return values;
}

int digit(char letter) {
    constexpr std::string_view alphabet =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const auto at = alphabet.find(letter);
    if (at == std::string_view::npos)
        throw InputError(fmt::format("'{}' is no letter of base64", letter));
    return int(at);
}

/// The encoded text from its header on, read piece by piece.
class Blocks {
public:
    Blocks(std::string_view encoded, const Encoding& encoding, bool is_base64)
        : encoded_(encoded), encoding_(encoding), is_base64_(is_base64) {}

    /// The first so many bytes.
    std::string first(std::size_t bytes) const {
        std::string found =
            is_base64_ ? from_base64(encoded_, bytes) : std::string(encoded_.substr(0, bytes));
        if (found.size() < bytes) throw InputError("a data array ends too early");
        found.resize(bytes);
        return found;
    }
    /// The first so many numbers of the header.
    std::vector<std::uint64_t> header(std::size_t count) const {
        const std::size_t size = encoding_.header_bytes;
        const std::string bytes = first(count * size);
        std::vector<std::uint64_t> numbers;
        for (std::size_t at = 0; at < bytes.size(); at += size)
            numbers.push_back(size == sizeof(std::uint64_t)
                                  ? number_at<std::uint64_t>(bytes, at, encoding_.is_big_endian)
                                  : number_at<std::uint32_t>(bytes, at, encoding_.is_big_endian));
        return numbers;
    }
    /// No more than could stand there: a broken header asks for anything.
    std::size_t size(std::uint64_t bytes) const {
        if (bytes > encoded_.size()) throw InputError("a data array ends too early");
        return std::size_t(bytes);
    }

private:
    std::string_view encoded_;
    const Encoding& encoding_;
    bool is_base64_;
};

std::string unzipped(std::string_view block, std::size_t size) {
    constexpr std::size_t densest = 1032;  // what deflate can reach
    if (size > densest * block.size() + densest)
        throw InputError("a compressed block says that it is larger than it can be");
    std::string bytes(size, '\0');
    auto length = uLongf(size);
    const int status =
        uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                   reinterpret_cast<const Bytef*>(block.data()), uLong(block.size()));
    if (status != Z_OK || length != size) throw InputError("a compressed block is broken");
    return bytes;
}

/// Header: count of blocks, size of each, size of the last if it is partial, compressed sizes.
std::string decompressed(const Blocks& blocks, std::size_t header_bytes) {
    const std::size_t count = blocks.size(blocks.header(1).front());
    if (count == 0) return {};
    constexpr std::size_t fixed = 3;
    const auto header = blocks.header(fixed + count);
    const std::uint64_t whole = header[1], last = header[2];
    const std::size_t header_size = header.size() * header_bytes;
    std::vector<std::size_t> packed;
    std::size_t total = header_size;
    for (std::size_t k = 0; k < count; ++k) {
        packed.push_back(blocks.size(header[fixed + k]));
        total += packed.back();
    }
    const std::string bytes = blocks.first(total);
    std::string all;
    std::size_t at = header_size;
    for (std::size_t k = 0; k < count; ++k) {
        const bool is_partial = k + 1 == count && last > 0;
        all += unzipped(std::string_view(bytes).substr(at, packed[k]), is_partial ? last : whole);
        at += packed[k];
    }
    return all;
}

}  // namespace

std::vector<double> numbers_in_text(std::string_view text) {
    constexpr auto blank = " \t\r\n";
    std::vector<double> values;
    for (std::size_t at = text.find_first_not_of(blank); at != everything;
         at = text.find_first_not_of(blank, at)) {
        const std::size_t end = std::min(text.find_first_of(blank, at), text.size());
        double value = 0.0;
        const auto [stop, error] = std::from_chars(text.data() + at, text.data() + end, value);
        if (error != std::errc() || stop != text.data() + end)
            throw InputError(fmt::format("\"{}\" is no number", text.substr(at, end - at)));
        values.push_back(value);
        at = end;
    }
    return values;
}

std::string from_base64(std::string_view text, std::size_t most) {
    constexpr int letters = 4, bits = 6, byte = 8;
    std::string bytes, four;
    for (const char letter : text) {
        if (bytes.size() >= most) break;
        if (std::isspace(static_cast<unsigned char>(letter)) != 0) continue;
        four += letter;
        if (four.size() < letters) continue;
        const auto padding = std::size_t(std::ranges::count(four, '='));
        std::uint32_t number = 0;
        for (const char one : four)
            number = (number << bits) | std::uint32_t(one == '=' ? 0 : digit(one));
        for (std::size_t k = 0; k + padding < 3; ++k)
            bytes += char((number >> (byte * (2 - k))) & 0xffU);
        four.clear();
    }
    return bytes;
}

std::string unpacked(std::string_view encoded, const Encoding& encoding, bool is_base64) {
    const Blocks blocks(encoded, encoding, is_base64);
    if (encoding.is_compressed) return decompressed(blocks, encoding.header_bytes);
    const std::size_t size = blocks.size(blocks.header(1).front());
    return blocks.first(encoding.header_bytes + size).substr(encoding.header_bytes);
}

std::vector<double> numbers_of(std::string_view bytes, const std::string& type,
                               bool is_big_endian) {
    if (type == "Float64") return numbers<double>(bytes, is_big_endian);
    if (type == "Float32") return numbers<float>(bytes, is_big_endian);
    if (type == "Int64") return numbers<std::int64_t>(bytes, is_big_endian);
    if (type == "UInt64") return numbers<std::uint64_t>(bytes, is_big_endian);
    if (type == "Int32") return numbers<std::int32_t>(bytes, is_big_endian);
    if (type == "UInt32") return numbers<std::uint32_t>(bytes, is_big_endian);
    if (type == "Int16") return numbers<std::int16_t>(bytes, is_big_endian);
    if (type == "UInt16") return numbers<std::uint16_t>(bytes, is_big_endian);
    if (type == "Int8") return numbers<std::int8_t>(bytes, is_big_endian);
    if (type == "UInt8") return numbers<std::uint8_t>(bytes, is_big_endian);
    throw InputError(fmt::format("a data array has type = \"{}\"", type));
}

}  // namespace crawford::vtk
