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

private:
    int file_;
};

}  // namespace crawford
