/// Files that are whole or absent: written under a name of their own beside the final one, then
/// renamed.
#pragma once

#include <filesystem>
#include <string_view>

namespace crawford {

/// Creates `directory` where it is missing.
/// \throws InputError if it cannot be created or nothing can be written into it.
void prepare_directory(const std::filesystem::path& directory);

/// A file in the making: whoever writes, writes to temporary(), in the same directory, and commit()
/// renames. Without commit() the temporary is removed and a file that was there before stays.
class AtomicFile {
public:
    /// Makes the directory of `target` if needed.
    /// \throws InputError if that fails.
    explicit AtomicFile(std::filesystem::path target);
    ~AtomicFile();
    AtomicFile(AtomicFile&&) noexcept;
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    AtomicFile& operator=(AtomicFile&&) = delete;

    const std::filesystem::path& target() const { return target_; }
    const std::filesystem::path& temporary() const { return temporary_; }

    /// Forces the content to the disk and gives it its final name, replacing what bore it.
    /// \throws InputError if nothing was written or that fails; the final name is then as it was.
    void commit();

private:
    std::filesystem::path target_;
    std::filesystem::path temporary_;  // empty once committed or moved from
};

/// Writes a whole file through an AtomicFile.
/// \throws InputError naming the file, if it cannot be written.
void write_file(const std::filesystem::path& path, std::string_view text);

/// Removes what a program that was killed has left half-written in `directory`. Only for who holds
/// the directory alone: files that others are writing look the same.
void remove_halves(const std::filesystem::path& directory);

}  // namespace crawford
