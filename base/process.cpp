#include "base/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace crawford {
namespace {

void check(int error, const std::string& what) {
    if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

/// Closed in the child by itself, so that no other program started meanwhile holds the writing end
/// open.
class Pipe {
public:
    Pipe() { check(pipe2(ends_.data(), O_CLOEXEC) == 0 ? 0 : errno, "cannot make a pipe"); }
    ~Pipe() {
        close(ends_[0]);
        close_writing();
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    int writing() const { return ends_[1]; }
    void close_writing() {
        if (ends_[1] >= 0) close(ends_[1]);
        ends_[1] = -1;
    }
    std::string read_all() const {
        std::string text;
        std::array<char, 4096> buffer{};
        for (;;) {
            const auto count = read(ends_[0], buffer.data(), buffer.size());
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) return text;
            text.append(buffer.data(), static_cast<std::size_t>(count));
        }
    }

private:
    std::array<int, 2> ends_{-1, -1};
};

/// Sends the child's output and errors into the pipe.
class Redirection {
public:
    explicit Redirection(int to) {
        check(posix_spawn_file_actions_init(&actions_), "cannot redirect");
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions_, to, STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions_, to, STDERR_FILENO);
    }
    ~Redirection() { posix_spawn_file_actions_destroy(&actions_); }
    Redirection(const Redirection&) = delete;
    Redirection& operator=(const Redirection&) = delete;
    const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_{};
};

int wait_for(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) check(errno, "cannot wait");
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

Finished run_program(const std::vector<std::string>& arguments) {
    std::vector<char*> argv;
    for (const auto& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);

    Pipe pipe;
    const Redirection redirection(pipe.writing());
    pid_t child = 0;
    check(posix_spawnp(&child, argv[0], redirection.get(), nullptr, argv.data(), environ),
          "cannot start " + arguments.at(0));
    pipe.close_writing();
    std::string output = pipe.read_all();
    return {wait_for(child), std::move(output)};
}

}  // namespace crawford
