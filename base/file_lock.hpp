/// One at a time, among threads and processes.
#pragma once

#include <filesystem>
#include <functional>

namespace crawford {

/// Holds a file locked as long as it lives. A process that is killed lets go.
class FileLock {
public:
    /// Creates the file if it is not there. Waits for whoever holds it now, and calls `waiting`
    /// before.
    /// \throws InputError if the file cannot be opened.
    explicit FileLock(const std::filesystem::path& path, const std::function<void()>& waiting = {});
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    /// Whether somebody holds it. Makes no file.
    static bool is_held(const std::filesystem::path& path);

private:
    int file_;
};

}  // namespace crawford
