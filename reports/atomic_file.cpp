#include "reports/atomic_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <random>
#include <system_error>
#include <utility>

namespace crawford::reports {
namespace fs = std::filesystem;
namespace {

/// Hidden, and unlike any other writer's, be it a thread or a process.
fs::path temporary_name(const fs::path& target) {
    std::random_device random;
    return target.parent_path() /
           fmt::format(".{}.{:08x}{:08x}.part", target.filename().string(), random(), random());
}

}  // namespace

AtomicFile::AtomicFile(fs::path target)
    : target_(std::move(target)), temporary_(temporary_name(target_)) {
    if (target_.has_parent_path()) fs::create_directories(target_.parent_path());
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : target_(std::move(other.target_)), temporary_(std::exchange(other.temporary_, {})) {}

AtomicFile::~AtomicFile() {
    std::error_code ignored;  // a destructor has nobody to tell
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void AtomicFile::commit() {
    fs::rename(temporary_, target_);
    temporary_.clear();
}

void write_atomically(const fs::path& target, std::string_view contents) {
    AtomicFile file(target);
    std::ofstream out(file.temporary(), std::ios::binary);
    out.write(contents.data(), static_cast<std::streamsize>(contents.size()));
    out.close();
    if (!out)
        throw fs::filesystem_error("cannot write", target,
                                   std::error_code(errno, std::generic_category()));
    file.commit();
}

}  // namespace crawford::reports
