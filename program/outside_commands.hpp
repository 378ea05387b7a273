/// The command lines of order, truth and judge: what the results of other codes are held with.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace crawford {

class OutsideCommands {
public:
    /// Adds the commands to the program's.
    explicit OutsideCommands(CLI::App& app);
    ~OutsideCommands();
    OutsideCommands(const OutsideCommands&) = delete;
    OutsideCommands& operator=(const OutsideCommands&) = delete;

    /// What was asked for by `command`, as typed; empty if it was none of these.
    /// These must outlive it.
    std::function<int()> action(const std::vector<std::string>& command) const;

private:
    struct Commands;
    std::unique_ptr<Commands> commands_;
};

}  // namespace crawford
