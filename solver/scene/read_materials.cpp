#include "solver/scene/read_materials.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/nearest_name.hpp"
#include "solver/scene/scene_keys.hpp"
#include "solver/scene/toml_key.hpp"

namespace crawford {

namespace {

void read(TomlTable& tables, Material& material, Need need, std::string_view remark) {
    if (!tables.has(material.name)) return;
    TomlTable table = tables.table(material.name);
    keys::visit(table, material, need);
    table.finish(remark);
}

}  // namespace

std::vector<Material> read_materials(TomlTable& scene) {
    TomlTable tables = scene.table("materials");
    std::vector<Material> materials{ammonium_perchlorate(), htpb_binder()};
    for (Material& material : materials) read(tables, material, Need::optional, "");
    const std::vector<std::string> built_in = names_of(materials);
    for (const std::string& name : tables.keys()) {
        if (std::find(built_in.begin(), built_in.end(), name) != built_in.end()) continue;
        const std::string nearest = nearest_name(name, built_in);
        Material material{};
        material.name = name;
        read(tables, material, Need::required,
             fmt::format("; a new material gives all properties{}",
                         nearest.empty() ? "" : fmt::format(", or did you mean {}?", nearest)));
        materials.push_back(material);
    }
    return materials;
}

std::vector<std::string> names_of(const std::vector<Material>& materials) {
    std::vector<std::string> names;
    for (const Material& material : materials) names.push_back(material.name);
    return names;
}

std::optional<Material> find_material(TomlTable& table, std::string_view key,
                                      const std::vector<Material>& materials,
                                      const std::optional<std::string>& otherwise) {
    std::string name = otherwise.value_or("");
    table.text(key, name, otherwise ? Need::optional : Need::required);
    if (!otherwise && !table.has(key)) return std::nullopt;
    for (const Material& material : materials) {
        if (material.name == name) return material;
    }
    table.refuse(key, fmt::format("is no material of this scene{}, or give all its properties in "
                                  "[materials.{}]",
                                  suggestion(name, names_of(materials)), toml_key(name)));
}

}  // namespace crawford
