/// A gate's result as an object for programs. Numbers that are none, or infinite, are null.
///
/// study, quantity, norm, kind ("order" or "bound"), grids, h, errors (bounds: values),
/// pairwise_orders, scale, coarsest, finest, fit, expected, tolerance ({below, above} of an order,
/// {low, high} of a bound), value (bounds), reason, uncertainty (the grid convergence index), limit
/// (Richardson's estimate and what it rests on), verdict, passed, gated, failure, seconds.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "reports/gate.hpp"

namespace crawford::reports {

void to_json(nlohmann::ordered_json& json, const GateResult& result);
void from_json(const nlohmann::ordered_json& json, GateResult& result);

}  // namespace crawford::reports
