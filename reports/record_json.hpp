/// Records as JSON: docs/output.md describes the members.
#pragma once

#include <nlohmann/json.hpp>

#include "reports/record.hpp"

namespace crawford::reports {

void to_json(nlohmann::ordered_json& json, const Setting& setting);
void from_json(const nlohmann::ordered_json& json, Setting& setting);

/// Numbers keep every bit; one that is not finite is a word: "nan", "inf", "-inf".
void to_json(nlohmann::ordered_json& json, const Record& record);
/// \throws nlohmann::json::exception or std::invalid_argument if a member is missing or of a wrong
/// kind.
void from_json(const nlohmann::ordered_json& json, Record& record);

}  // namespace crawford::reports
