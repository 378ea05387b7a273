#include "cases/registry.hpp"

#include <algorithm>
#include <utility>

#include "base/source_tree.hpp"

namespace crawford {

namespace {

/// Inside a function, so that it exists before the first case registers, in whatever order the
/// files are linked.
std::vector<Entry>& entries() {
    static std::vector<Entry> all;
    return all;
}

}  // namespace

const std::vector<Entry>& catalogue() {
    return entries();
}

Registered::Registered(Entry entry, const std::filesystem::path& file) {
    entry.source = place_in_source_tree(file);
    const auto after = std::ranges::upper_bound(entries(), entry.name, {}, &Entry::name);
    entries().insert(after, std::move(entry));
}

}  // namespace crawford
