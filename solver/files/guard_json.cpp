#include "solver/files/guard_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace crawford {

namespace {

nlohmann::ordered_json number(std::optional<double> value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json remark(const Guard& guard) {
    return {{"name", guard.name},
            {"value", guard.value},
            {"limit", number(guard.limit)},
            {"text", guard.text}};
}

}  // namespace

std::string to_json(const Guards& guards) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const Guard& guard : guards)
        json[guard.name] = {{"value", guard.value}, {"limit", number(guard.limit)}};
    return json.dump();
}

std::string remarks_to_json(const Guards& predicted, const Guards& met) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    const Guards later = remarks(met);
    for (const Guard& guard : remarks(predicted))
        if (std::ranges::find(later, guard.name, &Guard::name) == later.end())
            list.push_back(remark(guard));
    for (const Guard& guard : later) list.push_back(remark(guard));
    return list.dump();
}

}  // namespace crawford
