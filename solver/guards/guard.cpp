#include "solver/guards/guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/errors.hpp"

namespace crawford {

namespace {

/// To two digits, towards zero: what advice names must be within the limit.
double rounded_down(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    return std::floor(value / unit) * unit;
}

}  // namespace

std::string in_words(const Guard& guard) {
    const std::string limit = guard.limit ? fmt::format(", limit {:.4g}", *guard.limit) : "";
    const std::string text = guard.text.empty() ? "" : ": " + guard.text;
    return fmt::format("{} = {:.4g}{}{}", guard.name, guard.value, limit, text);
}

void advise_step(Guards& guards) {
    double longest = std::numeric_limits<double>::infinity();
    for (const Guard& guard : guards)
        if (guard.beyond != Beyond::nothing && guard.longest_step)
            longest = std::min(longest, *guard.longest_step);
    for (Guard& guard : guards)
        if (guard.beyond != Beyond::nothing && guard.longest_step)
            guard.text +=
                fmt::format("; reduce time.step to {:g} us or less", rounded_down(1e6 * longest));
}

bool is_worse(const Guard& a, const Guard& b) {
    if (a.beyond != b.beyond) return a.beyond > b.beyond;
    if (a.limit && b.limit && *a.limit != *b.limit) return a.value / *a.limit > b.value / *b.limit;
    return a.is_least ? a.value < b.value : a.value > b.value;
}

Guards remarks(const Guards& guards) {
    Guards found;
    std::ranges::copy_if(guards, std::back_inserter(found),
                         [](const Guard& guard) { return guard.beyond == Beyond::remark; });
    return found;
}

void refuse(const Guards& guards) {
    const auto worst = std::ranges::find(guards, Beyond::refusal, &Guard::beyond);
    if (worst != guards.end()) throw InputError(in_words(*worst));
}

}  // namespace crawford
