#include "base/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <random>
#include <string>
#include <utility>

#include "base/errors.hpp"

namespace crawford {

namespace fs = std::filesystem;

namespace {

constexpr auto half = ".part";

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
    throw InputError(fmt::format("cannot write {}: {}", path.string(), reason));
}

/// Hidden, and unlike any other writer's, be it a thread or a process.
fs::path temporary_name(const fs::path& target) {
    std::random_device random;
    return target.parent_path() /
           fmt::format(".{}.{:08x}{:08x}{}", target.filename().string(), random(), random(), half);
}

bool synchronise(const fs::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY);
    if (file < 0) return false;
    const bool synchronised = ::fsync(file) == 0;
    const int error = errno;
    ::close(file);
    errno = error;
    return synchronised;
}

}  // namespace

void prepare_directory(const fs::path& directory) {
    std::error_code error;
    fs::create_directories(directory, error);
    if (error) refuse(directory, error.message());
    const AtomicFile probe(directory / "writable");
    if (!std::ofstream(probe.temporary())) refuse(directory, std::strerror(errno));
}

AtomicFile::AtomicFile(fs::path target)
    : target_(std::move(target)), temporary_(temporary_name(target_)) {
    if (!target_.has_parent_path()) return;
    std::error_code error;
    fs::create_directories(target_.parent_path(), error);
    if (error) refuse(target_, error.message());
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : target_(std::move(other.target_)), temporary_(std::exchange(other.temporary_, {})) {}

AtomicFile::~AtomicFile() {
    std::error_code ignored;  // a destructor has nobody to tell
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void AtomicFile::commit() {
    // Without the synchronisation a machine that loses power could keep the name and lose the
    // content.
    if (!synchronise(temporary_)) refuse(target_, std::strerror(errno));
    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) refuse(target_, error.message());
    temporary_.clear();
}

void write_file(const fs::path& path, std::string_view text) {
    AtomicFile pending(path);
    std::ofstream file(pending.temporary(), std::ios::binary);
    file << text;
    file.close();
    if (!file) refuse(path, std::strerror(errno));
    pending.commit();
}

void remove_halves(const fs::path& directory) {
    for (const auto& entry : fs::directory_iterator(directory))
        if (entry.path().extension() == half) fs::remove(entry.path());
}

}  // namespace crawford
