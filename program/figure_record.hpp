/// What is kept beside a figure, <case>_manifest.json, and tells whether it must be drawn anew.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cases/registry.hpp"

namespace crawford {

struct FigureRecord {
    std::string fidelity;
    double seconds = 0.0;  ///< that drawing took, without burns that were there
    std::vector<Finding> findings = {};
    std::vector<std::filesystem::path> pictures = {};
    std::vector<std::filesystem::path> data = {};  ///< the numbers behind them
    std::vector<std::string> scenes = {};          ///< TOML
    std::string sources = {};                      ///< source_fingerprint() of the program

    /// Whether this program would draw the same at this fidelity, and all files are there.
    bool is_of(const std::string& wanted_fidelity) const;
};

/// Writes `directory`/<name>_manifest.json: where it comes from (`provenance`), then the record.
void write(const std::filesystem::path& directory, const std::string& name,
           const FigureRecord& record, nlohmann::ordered_json provenance);

/// Nothing if there is none or it cannot be understood: the figure is then drawn anew.
std::optional<FigureRecord> read_figure_record(const std::filesystem::path& directory,
                                               const std::string& name);

}  // namespace crawford
