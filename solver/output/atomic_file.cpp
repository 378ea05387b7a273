#include "solver/output/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>

#include "solver/errors.hpp"

namespace crawford {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason) {
    throw InputError(fmt::format("cannot write {}: {}", path.string(), reason));
}

bool synchronise(const std::filesystem::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY);
    if (file < 0) return false;
    const bool synchronised = ::fsync(file) == 0;
    const int error = errno;
    ::close(file);
    errno = error;
    return synchronised;
}

}  // namespace

void prepare_directory(const std::filesystem::path& directory) {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error) refuse(directory, error.message());
    const PendingFile probe(directory / "writable");
    if (!std::ofstream(probe.temporary())) refuse(directory, std::strerror(errno));
}

PendingFile::PendingFile(std::filesystem::path path)
    : path_(std::move(path)), temporary_(path_.string() + ".partial") {}

PendingFile::~PendingFile() {
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
}

void PendingFile::publish() {
    // Without the synchronisation a machine that loses power could keep the name and lose the
    // content.
    if (!synchronise(temporary_)) refuse(path_, std::strerror(errno));
    std::error_code error;
    std::filesystem::rename(temporary_, path_, error);
    if (error) refuse(path_, error.message());
}

void write_file(const std::filesystem::path& path, std::string_view text) {
    PendingFile pending(path);
    std::ofstream file(pending.temporary(), std::ios::binary);
    file << text;
    file.close();
    if (!file) refuse(path, std::strerror(errno));
    pending.publish();
}

}  // namespace crawford
