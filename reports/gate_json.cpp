#include "reports/gate_json.hpp"

#include <nlohmann/json.hpp>

#include "base/whole_number.hpp"

namespace crawford::reports {
namespace {

using Json = nlohmann::ordered_json;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A number, or what null stands for.
double number(const Json& json, const char* key, double null = not_applicable) {
    const auto& value = json.at(key);
    return value.is_null() ? null : value.get<double>();
}

std::vector<double> numbers(const Json& json, const char* key) {
    std::vector<double> values;
    for (const auto& value : json.at(key))
        values.push_back(value.is_null() ? not_applicable : value.get<double>());
    return values;
}

Json tolerance(const GateResult& r) {
    if (r.kind == GateKind::order) return {{"below", r.below}, {"above", r.above}};
    return {{"low", r.low}, {"high", r.high}};
}

void read_tolerance(const Json& json, GateResult& r) {
    if (r.kind == GateKind::order) {
        r.below = number(json, "below", infinity);
        r.above = number(json, "above", infinity);
    } else {
        r.low = number(json, "low", -infinity);
        r.high = number(json, "high", infinity);
    }
}

/// Pages and comparisons go along these side by side.
void refuse_unequal_lengths(const Json& json, const GateResult& r) {
    const std::size_t grids = r.grids.size();
    const std::size_t pairs = r.errors.empty() ? 0 : r.errors.size() - 1;
    if (r.h.size() != grids || r.errors.size() > grids || r.values.size() > grids ||
        r.pairwise.size() != pairs)
        throw Json::other_error::create(
            501, "grids, h, errors, values and pairwise_orders do not fit together", &json);
}

}  // namespace

void to_json(Json& json, const GateResult& r) {
    json = {{"study", r.study},
            {"quantity", r.quantity},
            {"norm", r.norm},
            {"kind", r.kind == GateKind::order ? "order" : "bound"},
            {"grids", r.grids},
            {"h", r.h},
            {"errors", r.errors},
            {"values", r.values},
            {"pairwise_orders", r.pairwise},
            {"scale", r.scale},
            {"coarsest", r.coarsest},
            {"finest", r.finest},
            {"fit", r.fit},
            {"expected", r.expected},
            {"tolerance", tolerance(r)},
            {"value", r.value},
            {"reason", r.reason},
            {"uncertainty", r.limit.uncertainty},
            {"limit",
             {{"value", r.limit.value},
              {"observed_order", r.limit.observed},
              {"order", r.limit.order},
              {"safety", r.limit.safety}}},
            {"verdict", r.verdict},
            {"passed", r.passed},
            {"gated", r.gated},
            {"failure", r.failure},
            {"seconds", r.seconds}};
}

void from_json(const Json& json, GateResult& r) {
    json.at("study").get_to(r.study);
    json.at("quantity").get_to(r.quantity);
    json.at("norm").get_to(r.norm);
    r.kind = json.at("kind") == "order" ? GateKind::order : GateKind::bound;
    r.grids = whole_numbers<int>(json.at("grids"));
    r.h = numbers(json, "h");
    r.errors = numbers(json, "errors");
    r.values = numbers(json, "values");
    r.pairwise = numbers(json, "pairwise_orders");
    refuse_unequal_lengths(json, r);
    r.scale = number(json, "scale");
    r.coarsest = whole_number<int>(json.at("coarsest"));
    r.finest = whole_number<int>(json.at("finest"));
    r.fit = number(json, "fit");
    r.expected = number(json, "expected");
    read_tolerance(json.at("tolerance"), r);
    r.value = number(json, "value");
    json.at("reason").get_to(r.reason);
    const auto& limit = json.at("limit");
    r.limit = {number(limit, "value"), number(json, "uncertainty"), number(limit, "observed_order"),
               number(limit, "order"), number(limit, "safety")};
    json.at("verdict").get_to(r.verdict);
    json.at("passed").get_to(r.passed);
    json.at("gated").get_to(r.gated);
    json.at("failure").get_to(r.failure);
    json.at("seconds").get_to(r.seconds);
}

}  // namespace crawford::reports
