#include "solver/scene/read_pack.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <limits>

#include "base/errors.hpp"
#include "solver/packing/apportion.hpp"
#include "solver/scene/scene_keys.hpp"

namespace crawford {

namespace {

constexpr std::string_view pack_word = "pack: ", seed_word = ", seed ";

constexpr IntegerLimits numbers{1, 2000};  // of discs: 2000 take a minute
constexpr Limits share_limits{"", 1e-6, 1e6};

/// Rows of radius and count.
std::vector<DiscSize> counted(TomlTable& table) {
    std::vector<DiscSize> sizes;
    int discs = 0;
    for (TomlTable& row : table.tables("discs")) {
        DiscSize size{};
        row.quantity("radius", size.radius, keys::length, Need::required);
        row.integer("count", size.count, numbers, Need::required);
        row.finish();
        discs += size.count;
        if (discs > numbers.most)
            table.refuse("discs", fmt::format("asks for more than {} discs", numbers.most));
        sizes.push_back(size);
    }
    return sizes;
}

/// Rows of radius and share, and the count of all.
std::vector<DiscSize> shared(TomlTable& table) {
    int count = 0;
    table.integer("count", count, numbers);
    std::vector<SizeShare> shares;
    for (TomlTable& row : table.tables("discs")) {
        SizeShare size{};
        row.quantity("radius", size.radius, keys::length, Need::required);
        row.number("share", size.share, share_limits, Need::required);
        row.finish();
        shares.push_back(size);
    }
    if (shares.empty()) return {};
    try {
        return apportion(shares, count);
    } catch (const InputError& error) {
        table.refuse("count", fmt::format("is too small: {}", error.what()));
    }
}

}  // namespace

PackRecipe read_recipe(TomlTable& table, double width) {
    int seed = 1;
    PackRecipe recipe{
        .width = width, .discs = {}, .area_fraction = 0.0, .smallest_gap = 0.0, .seed = 0};
    table.number("area_fraction", recipe.area_fraction, {"", 0.01, 0.99}, Need::required);
    table.quantity("smallest_gap", recipe.smallest_gap, {"m", 0.0, 1.0}, Need::required);
    table.integer("seed", seed, {0, std::numeric_limits<int>::max()});
    recipe.seed = static_cast<std::uint64_t>(seed);
    recipe.discs = table.has("count") ? shared(table) : counted(table);
    if (recipe.discs.empty())
        table.refuse("discs", "is missing; give [{ radius = \"38.4 um\", count = 21 }, ...]");
    return recipe;
}

std::string description(const PackRecipe& recipe) {
    constexpr double micrometre = 1e-6;  // [m]
    std::string sizes;
    for (const DiscSize& size : recipe.discs)
        sizes += fmt::format("{} of {:.6g} um, ", size.count, size.radius / micrometre);
    return fmt::format("{}{}area fraction {:.6g}, gaps of at least {:.6g} um{}{}", pack_word, sizes,
                       recipe.area_fraction, recipe.smallest_gap / micrometre, seed_word,
                       recipe.seed);
}

std::optional<std::uint64_t> seed_of(std::string_view description) {
    const auto word = description.rfind(seed_word);
    if (!description.starts_with(pack_word) || word == std::string_view::npos) return {};
    const std::string_view digits = description.substr(word + seed_word.size());
    std::uint64_t seed = 0;
    const auto [end, problem] = std::from_chars(digits.begin(), digits.end(), seed);
    if (problem != std::errc() || end != digits.end()) return {};
    return seed;
}

}  // namespace crawford
