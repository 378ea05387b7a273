#include "reference/truth_registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "reference/truth_entries.hpp"

namespace crawford::reference {

Truth TruthEntry::make(const Parameters& given) const {
    try {
        return build(Given(parameters, given));
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", name, error.what()));
    } catch (const std::invalid_argument& error) {
        throw InputError(fmt::format("{}: {}", name, error.what()));
    }
}

const std::vector<TruthEntry>& truths() {
    static const std::vector<TruthEntry> all{
        slab_entry(),
        slab_shooting_entry(),
        slab_small_strain_entry(),
        elastic_laminate_entry(),
        manufactured_burning_entry(),
    };
    return all;
}

const TruthEntry& find_truth(std::string_view name) {
    const auto found = std::ranges::find(truths(), name, &TruthEntry::name);
    if (found != truths().end()) return *found;
    std::vector<std::string> names;
    for (const TruthEntry& entry : truths()) names.push_back(entry.name);
    throw InputError(fmt::format("unknown truth {}{}", name, suggestion(name, names)));
}

Truth truth(std::string_view name, const Parameters& given) {
    return find_truth(name).make(given);
}

}  // namespace crawford::reference
