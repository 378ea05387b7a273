#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "reports/gate.hpp"

/// Gate results as a file for programs and as text for people.
namespace crawford::reports {

/// Every member of the result under its own name; NaN and infinity are null.
void to_json(nlohmann::json& json, const GateResult& result);

/// Writes {"passed": all of them (and at least one), "gates": [...]}, plus the members of `heading`
/// (version, revision, machine), atomically.
/// \throws std::filesystem::filesystem_error naming the file.
void write_json(const std::filesystem::path& file, const std::vector<GateResult>& results,
                const nlohmann::json& heading);
void write_json(const std::filesystem::path& file, const std::vector<GateResult>& results);

/// Plain text, at most 100 columns: each gate with its errors, pairwise orders, fit, verdict,
/// reason and pass or FAIL, and one closing line with the count.
std::string table(const std::vector<GateResult>& results);

/// True if there is at least one result and all have passed.
bool all_passed(const std::vector<GateResult>& results);

}  // namespace crawford::reports
