/// A judged table as JSON for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "reports/order_judgement.hpp"

namespace crawford::reports {

/// {"quantities": [{name, kind ("error" or "value"), h, values, pairwise_orders, fit, verdict,
/// passed (null where nothing is expected), failure, estimates: [{name, order, extrapolated,
/// uncertainty, relative_uncertainty, safety, note}]}]}; numbers that there are not are null.
nlohmann::ordered_json order_json(const std::vector<JudgedColumn>& columns);

}  // namespace crawford::reports
