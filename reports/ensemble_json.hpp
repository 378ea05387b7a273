/// An ensemble for programs.
#pragma once

#include <nlohmann/json.hpp>

#include "reports/ensemble.hpp"

namespace crawford::reports {

/// Points and burns, values with their units; null where there is none.
nlohmann::ordered_json ensemble_json(const Ensemble& ensemble);

}  // namespace crawford::reports
