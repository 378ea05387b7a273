/// What figures are drawn from, as JSON: a member of their records.
#pragma once

#include <nlohmann/json.hpp>

#include "reports/figure_contents.hpp"

namespace crawford::reports {

/// Tables that are gone with the figure are left out.
void to_json(nlohmann::ordered_json& json, const FigureContents& contents);
/// \throws nlohmann::json::exception or std::invalid_argument if a member is missing or of a wrong
/// kind.
void from_json(const nlohmann::ordered_json& json, FigureContents& contents);

}  // namespace crawford::reports
