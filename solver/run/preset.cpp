#include "solver/run/preset.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "base/errors.hpp"
#include "solver/guards/burning_guards.hpp"
#include "solver/guards/crossed.hpp"
#include "solver/guards/steady_slab.hpp"
#include "solver/mesh/grid.hpp"
#include "solver/scene/defaults.hpp"

namespace crawford {

namespace {

constexpr std::array keys{std::pair{"error", &Preset::error},
                          std::pair{"rows_in_layer", &Preset::rows_in_layer},
                          std::pair{"columns_in_layer", &Preset::columns_in_layer},
                          std::pair{"columns_in_feature", &Preset::columns_in_feature},
                          std::pair{"clustering", &Preset::clustering},
                          std::pair{"clustering_x", &Preset::clustering_x},
                          std::pair{"accuracy", &Preset::accuracy},
                          std::pair{"least_error", &Preset::least_error},
                          std::pair{"left_of_change", &Preset::left_of_change},
                          std::pair{"slowest", &Preset::slowest},
                          std::pair{"fastest", &Preset::fastest}};

/// How the materials burn, each by itself.
struct Burns {
    double slowest = std::numeric_limits<double>::infinity(), fastest = 0.0;  ///< [m/s]
    double wave = 0.0;                                                        ///< [m/s]
    double layer = 0.0;  ///< thinnest D/r_b [m]
};

Burns burns_of(const Scene& scene) {
    if (scene.physics.regression == Regression::fixed)
        throw InputError(
            "a preset promises V, and physics.regression = \"fixed\" prescribes it; choose domain "
            "and time.step by hand");
    Burns burns;
    double least_diffusivity = std::numeric_limits<double>::infinity();
    for (size_t k = 0; k < scene.morphology.materials.size(); ++k) {
        const Material& m = scene.morphology.materials[k];
        const SlabAnswer answer = steady_slab(scene, k);
        least_diffusivity = std::min(least_diffusivity, m.diffusivity());
        if (answer.burning != Burning::steady) continue;
        const SteadySlab& slab = answer.slab;
        burns.slowest = std::min(burns.slowest, slab.burn_rate);
        burns.fastest = std::max(burns.fastest, slab.burn_rate);
        const double z = zeldovich_number(m.activation_temperature, slab.surface_temperature,
                                          scene.bottom.temperature);
        burns.wave = std::max(burns.wave, front_speed(slab.burn_rate, z, 0.0));
    }
    if (burns.fastest <= 0.0)
        throw InputError(
            "a preset is chosen by how fast the scene burns, and nothing burns steadily here; set "
            "domain and time.step by hand");
    burns.layer = least_diffusivity / burns.fastest;
    return burns;
}

/// Diameter of the mean disc, by area.
double mean_diameter(const Discs& discs) {
    double area = 0.0, weighted = 0.0;
    for (const Disc& disc : discs.discs) {
        area += disc.radius * disc.radius;
        weighted += 2.0 * disc.radius * disc.radius * disc.radius;
    }
    return weighted / area;
}

int multiple_of_four(double count) {
    return std::max(8, 4 * int(std::ceil(count / 4.0 - 1e-9)));
}

/// Columns across the width: with the sides of a strip on nodes, if that takes no more than twice as
/// many.
int columns(const Preset& preset, const Scene& scene, double layer) {
    const double width = scene.domain.width;
    const auto fewest = [&](double feature) {
        return multiple_of_four(
            width * std::max(preset.columns_in_feature / feature, preset.columns_in_layer / layer));
    };
    if (const auto* discs = std::get_if<Discs>(&scene.morphology.shape))
        return fewest(mean_diameter(*discs));
    const auto* strip = std::get_if<Sandwich>(&scene.morphology.shape);
    if (strip == nullptr) return 1;
    const int least = fewest(strip->strip);
    for (int nx = least; nx <= 2 * least; nx += 4) {
        const double cells = 0.5 * strip->strip / width * nx;
        if (std::abs(cells - std::round(cells)) < 1e-6) return nx;
    }
    return least;
}

/// The fewest whose lowest is no higher.
int rows(Domain domain, double height) {
    for (domain.ny = 8;; domain.ny += 4)
        if (lowest_row(Grid(domain)) <= height) return domain.ny;
}

Domain domain_of(const Preset& preset, const Scene& scene, double layer) {
    const bool is_strip = std::holds_alternative<Sandwich>(scene.morphology.shape);
    Domain domain = scene.domain;
    domain.clustering = preset.clustering;
    domain.clustering_x = is_strip ? preset.clustering_x : 0.0;
    domain.nx = columns(preset, scene, layer);
    Domain column = domain;
    column.nx = 1;
    column.half = false;
    column.clustering_x = 0.0;
    domain.ny = rows(column, layer / preset.rows_in_layer);
    return domain;
}

/// Steps that "auto" will take: short ones while it ignites, then as long as waves of the surface,
/// rows and its accuracy let them be.
double expected_steps(const Preset& preset, const Scene& scene, const Domain& domain,
                      const Burns& burns) {
    constexpr double ignition = 150.0, to_a_layer = 0.3;  // measured at an accuracy of 1e-3
    const Grid grid(domain, strip_side(scene));
    double longest = to_a_layer * std::sqrt(preset.accuracy / 1e-3) * burns.layer / burns.fastest;
    longest = std::min(longest, 0.85 * lowest_row(grid) / burns.fastest);
    if (grid.cell_columns() > 1)
        longest = std::min(longest, 0.85 * front_crossing_limit(scene.time.scheme) *
                                        narrowest_column(grid) / burns.wave);
    return ignition + scene.time.end / longest;
}

std::vector<std::string> outside(const Preset& preset, const Burns& burns) {
    if (burns.slowest >= preset.slowest && burns.fastest <= preset.fastest) return {};
    return {fmt::format("burn rates of {:.3g} to {:.3g} cm/s; measured are {:.3g} to {:.3g}",
                        100.0 * burns.slowest, 100.0 * burns.fastest, 100.0 * preset.slowest,
                        100.0 * preset.fastest)};
}

}  // namespace

Preset read_preset(const std::filesystem::path& file) {
    Preset preset{};
    preset.name = file.stem().string();
    toml::table table;
    try {
        table = toml::parse_file(file.string());
    } catch (const toml::parse_error& error) {
        throw InputError(fmt::format("{}: {}", file.string(), error.description()));
    }
    for (const auto& [key, member] : keys) {
        const auto value = table[key].value<double>();
        if (!value) throw InputError(fmt::format("{}: {} is no number", file.string(), key));
        preset.*member = *value;
    }
    preset.measured = table["measured"].value_or(std::string());
    if (table.size() != keys.size() + 1 || preset.measured.empty())
        throw InputError(
            fmt::format("{}: needs a word on what was measured, and no other keys", file.string()));
    return preset;
}

Scene coarser(Scene scene) {
    Domain& domain = scene.domain;
    if (domain.nx > 1) domain.nx = multiple_of_four(0.5 * domain.nx);
    domain.ny = std::max(4, domain.ny / 2);
    if (scene.time.accuracy)
        scene.time.accuracy = std::min(4.0 * *scene.time.accuracy, 0.1);
    else
        scene.time.step *= 2.0;
    return scene;
}

Chosen choose(const Preset& preset, const Scene& scene) {
    const Burns burns = burns_of(scene);
    const Domain domain = domain_of(preset, scene, burns.layer);
    Chosen chosen{
        .keys = {fmt::format("domain.nx={}", domain.nx), fmt::format("domain.ny={}", domain.ny),
                 fmt::format("domain.clustering={}", domain.clustering)},
        .outside = outside(preset, burns),
        .seconds = 0.0,
        .megabytes = 0.0};
    if (domain.clustering_x != scene.domain.clustering_x)
        chosen.keys.push_back(fmt::format("domain.clustering_x={}", domain.clustering_x));
    chosen.keys.insert(chosen.keys.end(),
                       {"time.step=auto", fmt::format("time.accuracy={}", preset.accuracy)});
    // Measured: seconds of a cell and step, and bytes of a cell.
    const bool mechanics = scene.physics.mechanics;
    const bool half = std::holds_alternative<Sandwich>(scene.morphology.shape);
    const double cells = double(domain.nx) * domain.ny * (half ? 0.5 : 1.0);
    const double of_a_cell = (mechanics ? 3.5e-6 : 0.5e-6) * std::pow(cells / 3000.0, 0.2);
    chosen.seconds = cells * of_a_cell * expected_steps(preset, scene, domain, burns);
    chosen.megabytes = 25.0 + cells * (mechanics ? 5e-3 : 1e-3);
    return chosen;
}

}  // namespace crawford
