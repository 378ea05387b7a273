#include "solver/scene/read_scene.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <utility>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "solver/scene/check_scene.hpp"
#include "solver/scene/defaults.hpp"
#include "solver/scene/overrides.hpp"
#include "solver/scene/read_materials.hpp"
#include "solver/scene/read_morphology.hpp"
#include "solver/scene/scene_keys.hpp"
#include "solver/scene/toml_table.hpp"

namespace crawford {

namespace {

std::string read_text(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream || !std::filesystem::is_regular_file(path)) {
        throw InputError(fmt::format(
            "{}: the scene file cannot be opened; check the name and that it may be read",
            path.string()));
    }
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

toml::table parse(std::string_view text, const std::string& where) {
    try {
        return toml::parse(text, where);
    } catch (const toml::parse_error& error) {
        std::string reason(error.description());
        std::replace(reason.begin(), reason.end(), '\n', ' ');
        throw InputError(fmt::format("{}:{}: this is not TOML: {}; mend this line", where,
                                     error.source().begin.line, reason));
    }
}

template <class Part, class... Needs>
void read_part(TomlTable& scene, const char* key, Part& part, Needs... needs) {
    TomlTable table = scene.table(key);
    keys::visit(table, part, needs...);
    table.finish();
}

void read_physics(TomlTable& scene, Physics& physics) {
    TomlTable table = scene.table("physics");
    keys::visit(table, physics);
    if (!table.has("reference_map")) physics.reference_map = physics.mechanics;
    table.finish();
}

void read_numerics(TomlTable& scene, const Physics& physics, Numerics& numerics) {
    TomlTable table = scene.table("numerics");
    Readings readings = Readings::paper;
    keys::visit(table, readings);
    apply(readings, physics, numerics);
    keys::visit(table, numerics);
    if (!table.has("stress_work")) numerics.stress_work = numerics.thermal_stress;
    table.finish();
}

/// The flux of each of `burning`: one string for all or a table by material, which may hold the
/// other materials too.
std::vector<double> read_heat_flux(TomlTable& surface, const std::vector<Material>& burning,
                                   const std::vector<Material>& known, Need need) {
    std::vector<double> fluxes(burning.size(), 0.0);
    if (!surface.is_table("heat_flux")) {
        surface.quantity("heat_flux", fluxes.front(), keys::heat_flux, need);
        std::fill(fluxes.begin(), fluxes.end(), fluxes.front());
        return fluxes;
    }
    TomlTable table = surface.table("heat_flux");
    for (const Material& material : known) {
        double flux = 0.0;
        const auto burns = [&material](const Material& other) {
            return other.name == material.name;
        };
        const auto found = std::find_if(burning.begin(), burning.end(), burns);
        table.quantity(material.name, flux, keys::heat_flux,
                       found == burning.end() ? Need::optional : need);
        if (found != burning.end())
            fluxes[static_cast<std::size_t>(found - burning.begin())] = flux;
    }
    table.finish("; give the flux into each material, for example \"200 cal/(s cm2)\"");
    return fluxes;
}

/// A table that is there or not.
template <class Part>
void read_optional(TomlTable& parent, const char* key, std::optional<Part>& part) {
    if (!parent.has(key)) {
        parent.allow(key);
        return;
    }
    part.emplace();
    read_part(parent, key, *part);
}

void read_surface(TomlTable& root, Scene& scene, const std::vector<Material>& materials) {
    const auto when = [](bool needed) { return needed ? Need::required : Need::optional; };
    TomlTable table = root.table("surface");
    keys::visit(table, scene.surface, when(scene.physics.mechanics),
                when(scene.physics.regression == Regression::fixed));
    scene.surface.heat_flux =
        read_heat_flux(table, scene.morphology.materials, materials, when(scene.physics.heat));
    read_optional(table, "modulation", scene.surface.modulation);
    read_optional(table, "ripple", scene.surface.ripple);
    table.finish(
        fmt::format("; needed with physics.heat = {}, mechanics = {}, regression = {}",
                    scene.physics.heat, scene.physics.mechanics,
                    scene.physics.regression == Regression::fixed ? "\"fixed\"" : "not \"fixed\""));
}

Scene scene_of(const toml::table& text, const std::string& where,
               const std::filesystem::path& directory) {
    Scene scene;
    TomlTable root(&text, "", where);
    root.text("title", scene.title);
    for (const char* table : {"domain", "morphology", "materials", "physics", "surface", "bottom",
                              "time", "numerics", "output"}) {
        root.allow(table);
    }
    root.finish();
    read_part(root, "domain", scene.domain);
    const std::vector<Material> materials = read_materials(root);
    scene.morphology = read_morphology(root, materials, scene.domain, directory);
    read_physics(root, scene.physics);
    read_surface(root, scene, materials);
    read_part(root, "bottom", scene.bottom);
    read_part(root, "time", scene.time);
    read_numerics(root, scene.physics, scene.numerics);
    read_part(root, "output", scene.output);
    try {
        check(scene);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", where, error.what()));
    }
    return resolved(std::move(scene));
}

Scene parse_scene(std::string_view text, const std::string& where,
                  const std::filesystem::path& directory,
                  const std::vector<std::string>& overrides) {
    toml::table table = parse(text, where);
    for (const std::string& assignment : overrides) apply_override(table, assignment);
    return scene_of(table, where, directory);
}

}  // namespace

Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
    return parse_scene(read_text(path), path.string(), path.parent_path(), overrides);
}

Scene parse_scene(std::string_view text, const std::filesystem::path& directory,
                  const std::vector<std::string>& overrides) {
    return parse_scene(text, "scene", directory, overrides);
}

}  // namespace crawford
