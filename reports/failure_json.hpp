/// What is known of numbers that failed, as JSON: what does not apply is left out.
#pragma once

#include <nlohmann/json.hpp>

#include "base/errors.hpp"

namespace crawford {

void to_json(nlohmann::ordered_json& json, const FailureFields& fields);
/// \throws nlohmann::json::exception if a member is of a wrong kind.
void from_json(const nlohmann::ordered_json& json, FailureFields& fields);

}  // namespace crawford
