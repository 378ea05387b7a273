/// Files that are either whole or not there: written under a temporary name beside the final one,
/// then renamed.
#pragma once

#include <filesystem>
#include <string_view>

namespace crawford {

/// Creates `directory` where it is missing.
/// \throws InputError if it cannot be created or nothing can be written into it.
void prepare_directory(const std::filesystem::path& directory);

/// A file in the making. Write to temporary(), then publish(); a file never published is removed.
class PendingFile {
public:
    explicit PendingFile(std::filesystem::path path);
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    const std::filesystem::path& temporary() const { return temporary_; }

    /// Forces the content to the disk and gives it its final name, replacing what bore it.
    /// \throws InputError if that fails; the final name is then as it was.
    void publish();

private:
    std::filesystem::path path_;
    std::filesystem::path temporary_;
};

/// Writes a whole text file.
/// \throws InputError if it cannot be written.
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace crawford
