#include "base/json_member.hpp"

#include <fmt/format.h>

#include <limits>

namespace crawford {

JsonMember JsonMember::at(const std::string& key) const {
    const auto member = object().find(key);
    const auto where = where_.empty() ? key : where_ + '.' + key;
    if (member == json_->end()) throw JsonRefused(where + " is missing");
    return {*member, where};
}

bool JsonMember::has(const std::string& key) const {
    return object().contains(key);
}

std::vector<JsonMember> JsonMember::items() const {
    if (!json_->is_array()) refuse("is no list");
    std::vector<JsonMember> all;
    for (const Json& item : *json_)
        all.push_back(JsonMember(item, fmt::format("{}[{}]", where_, all.size())));
    return all;
}

std::string JsonMember::text() const {
    if (!json_->is_string()) refuse("is no text");
    return json_->get<std::string>();
}

bool JsonMember::truth() const {
    if (!json_->is_boolean()) refuse("is neither true nor false");
    return json_->get<bool>();
}

double JsonMember::number() const {
    return optional_number().value_or(std::numeric_limits<double>::quiet_NaN());
}

std::optional<double> JsonMember::optional_number() const {
    if (json_->is_null()) return {};
    if (!json_->is_number()) refuse("is no number");
    return json_->get<double>();
}

unsigned long JsonMember::count() const {
    if (!json_->is_number_unsigned()) refuse("is no whole number");
    return json_->get<unsigned long>();
}

std::vector<std::string> JsonMember::texts() const {
    std::vector<std::string> all;
    for (const JsonMember& item : items()) all.push_back(item.text());
    return all;
}

std::vector<double> JsonMember::numbers() const {
    std::vector<double> all;
    for (const JsonMember& item : items()) all.push_back(item.number());
    return all;
}

const JsonMember::Json& JsonMember::object() const {
    if (!json_->is_object()) refuse("is no object");
    return *json_;
}

void JsonMember::refuse(const std::string& what) const {
    throw JsonRefused((where_.empty() ? "the document" : where_) + ' ' + what);
}

}  // namespace crawford
