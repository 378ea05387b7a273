#include "solver/scene/write_scene.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>

#include "solver/scene/defaults.hpp"
#include "solver/scene/scene_keys.hpp"
#include "solver/scene/toml_key.hpp"

namespace crawford {

namespace {

std::string with_unit(double value, const char* unit) {
    return fmt::format("\"{} {}\"", value, unit);
}

/// The counterpart of TomlTable: writes what that one reads.
class TomlWriter {
public:
    void section(std::string_view name) { text_ += fmt::format("\n[{}]\n", name); }
    void line(std::string_view key, std::string_view value) {
        text_ += fmt::format("{} = {}\n", key, value);
    }

    void quantity(const char* key, double value, const Limits& limits, Need = Need::optional) {
        line(key, with_unit(value, limits.unit));
    }
    void quantity(const char* key, const std::optional<double>& value, const Limits& limits) {
        if (value) quantity(key, *value, limits);
    }
    void number(const char* key, double value, const Limits&, Need = Need::optional) {
        line(key, fmt::format("{}", value));
    }
    void number(const char* key, const std::optional<double>& value, const Limits& limits) {
        if (value) number(key, *value, limits);
    }
    void integer(const char* key, int value, const IntegerLimits&, Need = Need::optional) {
        line(key, fmt::format("{}", value));
    }
    void quantity_or(std::string_view word, bool is_word, const char* key, double value,
                     const Limits& limits) {
        if (is_word)
            text(key, word);
        else
            quantity(key, value, limits);
    }
    void flag(const char* key, bool value) { line(key, value ? "true" : "false"); }
    void text(const char* key, std::string_view value) { line(key, in_quotes(value)); }
    template <class Choice, std::size_t n>
    void choice(const char* key, Choice value, const std::array<Word<Choice>, n>& words) {
        for (const auto& word : words) {
            if (word.meaning == value) text(key, word.word);
        }
    }

    const std::string& written() const { return text_; }

private:
    std::string text_;
};

void write(TomlWriter& out, const Uniform&, const std::vector<Material>& materials) {
    out.text("kind", "uniform");
    out.text("material", materials.at(0).name);
}

void write(TomlWriter& out, const Sandwich& shape, const std::vector<Material>& materials) {
    out.text("kind", "sandwich");
    out.quantity("strip", shape.strip, keys::length);
    out.text("outer", materials.at(0).name);
    out.text("inner", materials.at(1).name);
}

void write(TomlWriter& out, const Discs& shape, const std::vector<Material>& materials) {
    out.text("kind", "discs");
    out.text("particle", materials.at(0).name);
    out.text("matrix", materials.at(1).name);
    out.quantity("period", shape.period, keys::length);
    out.text("source", shape.source);
    std::string rows = "[\n";
    for (const Disc& disc : shape.discs) {
        rows += fmt::format("    {{ x = {}, y = {}, radius = {} }},\n", with_unit(disc.x, "m"),
                            with_unit(disc.y, "m"), with_unit(disc.radius, "m"));
    }
    out.line("discs", rows + "]");
}

std::string heat_flux(const Scene& scene) {
    std::string fluxes;
    for (std::size_t i = 0; i < scene.morphology.materials.size(); ++i) {
        fluxes += fmt::format("{}{} = {}", i == 0 ? "" : ", ",
                              in_quotes(scene.morphology.materials[i].name),
                              with_unit(scene.surface.heat_flux.at(i), keys::heat_flux.unit));
    }
    return fmt::format("{{ {} }}", fluxes);
}

}  // namespace

std::string to_toml(const Scene& scene) {
    Scene s = resolved(scene);  // a variable, for the keys are visited for reading too
    TomlWriter out;
    out.text("title", s.title);
    out.section("domain");
    keys::visit(out, s.domain);
    out.section("morphology");
    std::visit([&](const auto& shape) { write(out, shape, s.morphology.materials); },
               s.morphology.shape);
    if (s.morphology.materials.size() > 1) keys::visit(out, s.morphology.indicator);
    for (Material& material : s.morphology.materials) {
        out.section("materials." + in_quotes(material.name));
        keys::visit(out, material, Need::required);
    }
    out.section("physics");
    keys::visit(out, s.physics);
    out.section("surface");
    keys::visit(out, s.surface, Need::optional, Need::optional);
    if (!s.surface.heat_flux.empty()) out.line("heat_flux", heat_flux(s));
    if (s.surface.modulation) {
        out.section("surface.modulation");
        keys::visit(out, *s.surface.modulation);
    }
    if (s.surface.ripple) {
        out.section("surface.ripple");
        keys::visit(out, *s.surface.ripple);
    }
    out.section("bottom");
    keys::visit(out, s.bottom);
    out.section("time");
    keys::visit(out, s.time);
    out.section("numerics");
    if (auto readings = readings_of(s.physics, s.numerics)) keys::visit(out, *readings);
    keys::visit(out, s.numerics);
    out.section("output");
    keys::visit(out, s.output);
    return out.written();
}

}  // namespace crawford
