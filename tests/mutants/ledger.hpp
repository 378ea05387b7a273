/// What has been found so far, kept on disk so that a run goes on where another one stopped.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "workshop.hpp"

namespace crawford::mutants {

class Ledger {
public:
    /// Reads `file` if it is there.
    /// \throws std::runtime_error if it holds something else.
    explicit Ledger(std::filesystem::path file);

    std::optional<Finding> find(const std::string& key) const;

    /// Keeps a finding, on disk too.
    void keep(const std::string& key, const Finding& finding);

private:
    std::filesystem::path file_;
    std::map<std::string, Finding> findings_;
};

}  // namespace crawford::mutants
