/// An ensemble for programs.
#pragma once

#include <string>

#include "reports/ensemble.hpp"

namespace crawford::reports {

/// JSON text of points and burns, values with their units; null where there is none.
std::string ensemble_json(const Ensemble& ensemble);

}  // namespace crawford::reports
