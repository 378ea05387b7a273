#pragma once

#include <filesystem>
#include <string_view>

namespace crawford::reports {

/// A file that appears under its final name complete or not at all: whoever writes, writes to
/// temporary(), in the same directory, and commit() renames. Without commit() the temporary is
/// removed and a file that was there before stays.
class AtomicFile {
public:
    /// Makes the directory of `target` if needed.
    /// \throws std::filesystem::filesystem_error if that fails.
    explicit AtomicFile(std::filesystem::path target);
    ~AtomicFile();
    AtomicFile(AtomicFile&&) noexcept;
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    AtomicFile& operator=(AtomicFile&&) = delete;

    const std::filesystem::path& target() const { return target_; }
    const std::filesystem::path& temporary() const { return temporary_; }

    /// \throws std::filesystem::filesystem_error if nothing was written or the rename fails.
    void commit();

private:
    std::filesystem::path target_;
    std::filesystem::path temporary_;  // empty once committed or moved from
};

/// Writes `contents` to `target` through an AtomicFile.
/// \throws std::filesystem::filesystem_error naming the file.
void write_atomically(const std::filesystem::path& target, std::string_view contents);

}  // namespace crawford::reports
