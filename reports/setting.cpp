#include "reports/setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace crawford::reports {

std::string text(const AxisValue& value) {
    if (const auto* const count = std::get_if<long>(&value)) return fmt::format("{}", *count);
    if (const auto* const word = std::get_if<std::string>(&value)) return *word;
    const auto& quantity = std::get<Amount>(value);
    return fmt::format("{} {}", quantity.value, quantity.unit);
}

Setting& Setting::set(const std::string& axis, AxisValue value) {
    const auto at = std::ranges::find(axes_, axis, &Axis::first);
    if (at == axes_.end())
        axes_.emplace_back(axis, std::move(value));
    else
        at->second = std::move(value);
    return *this;
}

bool Setting::has(const std::string& axis) const {
    return std::ranges::find(axes_, axis, &Axis::first) != axes_.end();
}

template <class Value>
const Value& Setting::get(const std::string& axis, const char* kind) const {
    const auto at = std::ranges::find(axes_, axis, &Axis::first);
    const auto* const value = at == axes_.end() ? nullptr : std::get_if<Value>(&at->second);
    if (value == nullptr)
        throw std::invalid_argument(fmt::format("no {} \"{}\" in \"{}\"", kind, axis, text()));
    return *value;
}

int Setting::count(const std::string& axis) const {
    return int(get<long>(axis, "count"));
}

double Setting::number(const std::string& axis) const {
    return get<Amount>(axis, "quantity").value;
}

const std::string& Setting::word(const std::string& axis) const {
    return get<std::string>(axis, "word");
}

std::string Setting::text() const {
    std::string all;
    for (const auto& [axis, value] : axes_)
        all += fmt::format("{}{} = {}", all.empty() ? "" : ", ", axis, reports::text(value));
    return all;
}

}  // namespace crawford::reports
