/// Reading a JSON document so that what is wrong in it is named.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace crawford {

/// A member is missing or is not what it should be; what() names it: "rows[2].unit is missing".
class JsonRefused : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A value in a document, and where it stands there. Null stands for what is no number.
class JsonMember {
public:
    using Json = nlohmann::ordered_json;

    /// The whole of `document`, which must outlive all that is reached from here.
    explicit JsonMember(const Json& document) : json_(&document) {}

    /// \throws JsonRefused if this is no object or has no such member, as all below do for a value
    /// of another kind.
    JsonMember at(const std::string& key) const;
    bool has(const std::string& key) const;
    std::vector<JsonMember> items() const;

    std::string text() const;
    bool truth() const;
    double number() const;  ///< NaN for null
    std::optional<double> optional_number() const;
    unsigned long count() const;  ///< A whole number, 0 or more
    std::vector<std::string> texts() const;
    std::vector<double> numbers() const;
    const Json& object() const;

    /// Refuses it: "<where> <what>".
    [[noreturn]] void refuse(const std::string& what) const;

private:
    JsonMember(const Json& json, std::string where) : json_(&json), where_(std::move(where)) {}

    const Json* json_;
    std::string where_;  // empty at the top
};

}  // namespace crawford
