#include "solver/guards/guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/errors.hpp"

namespace crawford {

std::string in_words(const Guard& guard) {
    const std::string limit = guard.limit ? fmt::format(", limit {:.4g}", *guard.limit) : "";
    const std::string text = guard.text.empty() ? "" : ": " + guard.text;
    return fmt::format("{} = {:.4g}{}{}", guard.name, guard.value, limit, text);
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
