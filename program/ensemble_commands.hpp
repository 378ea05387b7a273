/// The command lines of runs and gather: what many burns are kept track of with.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace crawford {

class EnsembleCommands {
public:
    /// Adds the commands to the program's.
    explicit EnsembleCommands(CLI::App& app);
    ~EnsembleCommands();
    EnsembleCommands(const EnsembleCommands&) = delete;
    EnsembleCommands& operator=(const EnsembleCommands&) = delete;

    /// What was asked for by `command`, as typed; empty if it was none of these.
    /// These must outlive it.
    std::function<int()> action(const std::vector<std::string>& command) const;

private:
    struct Commands;
    std::unique_ptr<Commands> commands_;
};

}  // namespace crawford
