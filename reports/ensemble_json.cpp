#include "reports/ensemble_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace crawford::reports {

namespace {

using Json = nlohmann::ordered_json;

Json amount(double value, const char* unit) {
    return {{"value", std::isfinite(value) ? Json(value) : Json()}, {"unit", unit}};
}

Json json_of(const Conditions& c) {
    return {{"area_fraction", amount(c.area_fraction, "1")},
            {"pressure", amount(c.pressure, "Pa")},
            {"readings", c.readings},
            {"columns", c.columns},
            {"rows", c.rows},
            {"end", amount(c.end, "s")},
            {"after", amount(c.after, "s")}};
}

Json json_of(const EnsemblePoint& point) {
    Json quantities = Json::array();
    for (std::size_t q = 0; q < ensemble_quantities.size(); ++q) {
        const auto& [name, symbol, unit] = ensemble_quantities[q];
        const Spread& found = point.spreads[q];
        quantities.push_back({{"name", name},
                              {"count", found.count},
                              {"mean", amount(found.mean, unit)},
                              {"standard_deviation", amount(found.standard_deviation, unit)},
                              {"half_width", amount(found.half_width, unit)},
                              {"packs_needed", point.needed[q] ? Json(*point.needed[q]) : Json()}});
    }
    return {{"conditions", json_of(point.conditions)},
            {"burns", point.burns},
            {"quantities", quantities}};
}

Json json_of(const EnsembleBurn& burn) {
    Json json = {{"key", burn.key},       {"conditions", json_of(burn.conditions)},
                 {"seed", burn.seed},     {"state", burn.state},
                 {"reason", burn.reason}, {"values", Json::object()}};
    for (std::size_t q = 0; q < ensemble_quantities.size(); ++q)
        json["values"][ensemble_quantities[q].name] =
            amount(burn.values[q], ensemble_quantities[q].unit);
    return json;
}

}  // namespace

std::string ensemble_json(const Ensemble& ensemble) {
    Json json = {{"confidence", ensemble.demand.confidence},
                 {"interval", ensemble.demand.interval},
                 {"points", Json::array()},
                 {"burns", Json::array()}};
    for (const EnsemblePoint& point : ensemble.points) json["points"].push_back(json_of(point));
    for (const EnsembleBurn& burn : ensemble.burns) json["burns"].push_back(json_of(burn));
    // Reasons may name files, and those need not be UTF-8.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace crawford::reports
