/// Whole numbers from JSON.
#pragma once

#include <concepts>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace crawford {

/// A whole number as it stands there. nlohmann's get() would cut off what is behind a point, and beyond the range of the type
/// give anything.
/// \throws nlohmann::json::type_error if it is none, or none of that type.
template <std::integral Whole, class Json>
Whole whole_number(const Json& json) {
    const bool fits =
        json.is_number_unsigned()
            ? std::in_range<Whole>(json.template get<typename Json::number_unsigned_t>())
            : json.is_number_integer() &&
                  std::in_range<Whole>(json.template get<typename Json::number_integer_t>());
    if (!fits)
        throw Json::type_error::create(302, "type must be a whole number that is not too large",
                                       &json);
    return json.template get<Whole>();
}

/// A list of them.
template <std::integral Whole, class Json>
std::vector<Whole> whole_numbers(const Json& json) {
    if (!json.is_array())
        throw Json::type_error::create(302, "type must be a list of whole numbers", &json);
    std::vector<Whole> all;
    for (const Json& item : json) all.push_back(whole_number<Whole>(item));
    return all;
}

}  // namespace crawford
