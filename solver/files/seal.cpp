#include "solver/files/seal.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <utility>

#include "base/atomic_file.hpp"
#include "base/digest.hpp"
#include "base/errors.hpp"

namespace crawford {

namespace {

constexpr std::string_view mark = "crawford, digest of what follows these 512 bytes: ";
constexpr size_t seal_size = 512;  ///< the least at which HDF5 looks for its data, after 0
constexpr std::string_view hdf5_mark = "\x89HDF\r\n\x1a\n";

/// All of it is compared, the filling as well: no byte of a file goes unchecked.
std::string seal_of(std::string_view content) {
    std::string seal = std::string(mark) + digest(content) + '\n';
    seal.resize(seal_size, '\0');
    return seal;
}

std::string bytes_of(const std::filesystem::path& path) {
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    // What can be opened need not be readable: a directory is not.
    if (!file || (file.peek() != EOF && !(bytes << file.rdbuf())) || file.bad())
        throw InputError(fmt::format("cannot read {}: {}", path.string(), std::strerror(errno)));
    return std::move(bytes).str();
}

}  // namespace

void write_sealed(const std::filesystem::path& path, std::string_view content) {
    write_file(path, seal_of(content) + std::string(content));
}

std::string read_sealed(const std::filesystem::path& path) {
    std::string bytes = bytes_of(path);
    if (bytes.starts_with(hdf5_mark))
        throw InputError(fmt::format(
            "{} is no checkpoint, or an earlier version wrote it, without a digest; give one that "
            "this `crawford burn` wrote",
            path.string()));
    if (bytes.size() < seal_size ||
        bytes.compare(0, seal_size, seal_of(std::string_view(bytes).substr(seal_size))) != 0)
        throw InputError(
            fmt::format("{} is damaged, or no checkpoint: it does not begin with the digest of its "
                        "content; restart from an earlier one",
                        path.string()));
    return bytes.erase(0, seal_size);
}

}  // namespace crawford
