#include "reports/order_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "reports/default_estimate.hpp"

namespace crawford::reports {

nlohmann::ordered_json order_json(const std::vector<JudgedColumn>& columns) {
    using Json = nlohmann::ordered_json;
    Json quantities = Json::array();
    for (const JudgedColumn& column : columns) {
        const GateResult& r = column.result;
        Json all = Json::array();
        for (const Estimate& e : column.estimates)
            all.push_back({{"name", e.name},
                           {"order", e.order},
                           {"extrapolated", e.extrapolated},
                           {"uncertainty", e.uncertainty},
                           {"relative_uncertainty", e.relative_uncertainty},
                           {"safety", e.safety},
                           {"note", e.note}});
        quantities.push_back({{"name", r.quantity},
                              {"kind", column.is_error ? "error" : "value"},
                              {"h", r.h},
                              {"values", column.values()},
                              {"pairwise_orders", r.pairwise},
                              {"fit", r.fit},
                              {"verdict", r.verdict},
                              {"passed", r.gated ? Json(r.passed) : Json(nullptr)},
                              {"failure", r.failure},
                              {"estimate", default_estimate},
                              {"estimates", std::move(all)}});
    }
    return {{"quantities", std::move(quantities)}};
}

}  // namespace crawford::reports
