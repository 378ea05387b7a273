#include "solver/scene/read_morphology.hpp"

#include <fmt/format.h>

#include <string>

#include "base/errors.hpp"
#include "solver/scene/read_discs.hpp"
#include "solver/scene/read_materials.hpp"
#include "solver/scene/read_pack.hpp"
#include "solver/scene/scene_keys.hpp"

namespace crawford {

namespace {

/// The finished morphology; finish() comes before the materials are taken, for they may be what is
/// missing.
Morphology finished(TomlTable& table, Shape shape,
                    const std::vector<std::optional<Material>>& materials) {
    Morphology morphology{.shape = std::move(shape), .materials = {}};
    if (materials.size() > 1) keys::visit(table, morphology.indicator);
    table.finish();
    for (const auto& material : materials) morphology.materials.push_back(material.value());
    return morphology;
}

Morphology uniform(TomlTable& table, const std::vector<Material>& materials) {
    const auto material = find_material(table, "material", materials, std::nullopt);
    return finished(table, Uniform{}, {material});
}

Morphology sandwich(TomlTable& table, const std::vector<Material>& materials) {
    Sandwich shape{};
    table.quantity("strip", shape.strip, keys::length, Need::required);
    const auto outer = find_material(table, "outer", materials, "AP");
    const auto inner = find_material(table, "inner", materials, "binder");
    return finished(table, shape, {outer, inner});
}

std::vector<Disc> inline_discs(TomlTable& table) {
    constexpr Limits coordinate{"m", -1.0, 1.0};
    std::vector<Disc> discs;
    for (TomlTable& row : table.tables("discs")) {
        Disc disc{};
        row.quantity("x", disc.x, coordinate, Need::required);
        row.quantity("y", disc.y, coordinate, Need::required);
        row.quantity("radius", disc.radius, keys::length, Need::required);
        row.finish();
        discs.push_back(disc);
    }
    return discs;
}

std::vector<Disc> discs_of_file(TomlTable& table, const std::string& file,
                                const std::filesystem::path& directory) {
    try {
        return read_discs(directory / file);
    } catch (const InputError& error) {
        table.refuse("file", fmt::format("cannot be used: {}", error.what()));
    }
}

Morphology discs(TomlTable& table, const std::vector<Material>& materials, double depth,
                 const std::filesystem::path& directory) {
    Discs shape{.discs = {}, .period = depth, .source = ""};
    table.quantity("period", shape.period, keys::length);
    const auto particle = find_material(table, "particle", materials, "AP");
    const auto matrix = find_material(table, "matrix", materials, "binder");
    if (table.has("discs")) {
        shape.discs = inline_discs(table);
        table.text("source", shape.source);
        return finished(table, std::move(shape), {particle, matrix});
    }
    table.text("file", shape.source, Need::required);
    Morphology morphology = finished(table, shape, {particle, matrix});
    shape.discs = discs_of_file(table, shape.source, directory);
    morphology.shape = std::move(shape);
    return morphology;
}

Morphology pack(TomlTable& table, const std::vector<Material>& materials, double width) {
    const PackRecipe recipe = read_recipe(table, width);
    const auto particle = find_material(table, "particle", materials, "AP");
    const auto matrix = find_material(table, "matrix", materials, "binder");
    Morphology morphology = finished(table, Uniform{}, {particle, matrix});
    try {
        Discs shape = random_pack(recipe);
        shape.source = description(recipe);
        morphology.shape = std::move(shape);
    } catch (const InputError& error) {
        table.refuse("area_fraction", fmt::format("cannot be had: {}", error.what()));
    }
    return morphology;
}

}  // namespace

Morphology read_morphology(TomlTable& scene, const std::vector<Material>& materials,
                           const Domain& domain, const std::filesystem::path& directory) {
    TomlTable table = scene.table("morphology");
    const auto kind =
        table.index_of("kind", {"uniform", "sandwich", "discs", "pack"}, Need::required);
    if (!kind) table.finish("; give \"uniform\", \"sandwich\", \"discs\" or \"pack\"");
    if (*kind == 0) return uniform(table, materials);
    if (*kind == 1) return sandwich(table, materials);
    if (*kind == 2) return discs(table, materials, domain.depth, directory);
    return pack(table, materials, domain.width);
}

}  // namespace crawford
