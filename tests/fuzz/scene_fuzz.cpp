/// Scenes: read, checked, what is predicted of them, written and read again.
#include <toml++/toml.h>

#include "solver/guards/predicted.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/scene/write_scene.hpp"
#include "tests/fuzz/contract.hpp"

namespace {

/// Packs of many discs and fine grids are slow by right, and teach nothing: whole numbers stay small.
bool is_quick(const toml::node& node) {
    constexpr std::int64_t most = 200;
    bool quick = true;
    if (const auto* number = node.as_integer()) return std::abs(number->get()) <= most;
    if (const auto* table = node.as_table())
        for (const auto& [key, value] : *table) quick = quick && is_quick(value);
    if (const auto* array = node.as_array())
        for (const auto& value : *array) quick = quick && is_quick(value);
    return quick;
}

bool is_quick(std::string_view text) {
    try {
        return is_quick(toml::parse(text));
    } catch (const toml::parse_error&) {
        return true;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const auto text = crawford::fuzz::text_of(bytes, size);
    if (!is_quick(text)) return -1;
    crawford::fuzz::must_answer([&] {
        const crawford::Scene scene = crawford::parse_scene(text, "/nowhere");
        crawford::predicted(scene);
        crawford::parse_scene(crawford::to_toml(scene), "/nowhere");
    });
    return 0;
}
