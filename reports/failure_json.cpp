#include "reports/failure_json.hpp"

#include <concepts>

#include "base/whole_number.hpp"

namespace crawford {

namespace {

using Json = nlohmann::ordered_json;
using Kind = FailureFields::Kind;

Kind kind_named(const std::string& word) {
    for (const Kind kind :
         {Kind::not_finite, Kind::not_positive_definite, Kind::no_convergence, Kind::beyond_limit})
        if (name_of(kind) == word) return kind;
    return Kind::told;
}

template <class Value>
void put(Json& json, const char* key, const std::optional<Value>& value) {
    if (value) json[key] = *value;
}

void take(const Json& json, const char* key, std::optional<double>& value) {
    if (json.contains(key)) value = json.at(key).get<double>();
}

template <std::integral Whole>
void take(const Json& json, const char* key, std::optional<Whole>& value) {
    if (json.contains(key)) value = whole_number<Whole>(json.at(key));
}

}  // namespace

void to_json(Json& json, const FailureFields& fields) {
    json["kind"] = name_of(fields.kind);
    json["module"] = fields.module;
    json["quantity"] = fields.quantity;
    put(json, "value", fields.value);
    json["unit"] = fields.unit;
    if (fields.limit)
        json["limit"] = {{"value", fields.limit->value},
                         {"is_least", fields.limit->is_least},
                         {"condition", fields.limit->condition}};
    if (fields.place) {
        json["place"] = {{"of", fields.place->of}, {"i", fields.place->i}};
        put(json["place"], "j", fields.place->j);
    }
    put(json, "step", fields.step);
    put(json, "time", fields.time);
    json["advice"] = fields.advice;
}

void from_json(const Json& json, FailureFields& fields) {
    fields.kind = kind_named(json.at("kind"));
    json.at("module").get_to(fields.module);
    json.at("quantity").get_to(fields.quantity);
    take(json, "value", fields.value);
    json.at("unit").get_to(fields.unit);
    if (json.contains("limit")) {
        const auto& limit = json.at("limit");
        fields.limit = {limit.at("value"), limit.at("is_least"), limit.at("condition")};
    }
    if (json.contains("place")) {
        fields.place = {json.at("place").at("of"), whole_number<int>(json.at("place").at("i"))};
        take(json.at("place"), "j", fields.place->j);
    }
    take(json, "step", fields.step);
    take(json, "time", fields.time);
    json.at("advice").get_to(fields.advice);
}

}  // namespace crawford
