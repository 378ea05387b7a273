#include "solver/guards/grid_guards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "solver/guards/crossed.hpp"

namespace crawford {

namespace {

Guard no_more_than(std::string name, double value, double limit, std::string text) {
    const bool beyond = !(value <= limit);
    return {.name = std::move(name),
            .value = value,
            .limit = limit,
            .beyond = beyond ? Beyond::remark : Beyond::nothing,
            .text = beyond ? std::move(text) : ""};
}

/// Central differences across a cell of Peclet number Pe leave this of a temperature above the
/// bottom's.
double left_below(double peclet) {
    return (2.0 - peclet) / (2.0 + peclet);
}

/// Whether a mean column is wider than half the thinnest thermal layer.
bool is_wide(const Scene& scene, double burn_rate) {
    double thinnest = std::numeric_limits<double>::infinity();
    for (const Material& m : scene.morphology.materials)
        thinnest = std::min(thinnest, m.diffusivity() / burn_rate);
    return scene.domain.width / scene.domain.nx > 0.5 * thinnest;
}

/// Whether the strip burns faster than what is around it where both are as hot.
bool strip_leads(const Scene& scene) {
    if (scene.physics.regression != Regression::pyrolysis) return false;
    constexpr double hot = 900.0;  // [K], as surfaces of propellants are
    const Material& around = scene.morphology.materials.front();
    const Material& strip = scene.morphology.materials.back();
    const auto rate = [](const Material& m) {
        return m.pyrolysis_prefactor * std::exp(-m.activation_temperature / hot);
    };
    return rate(strip) > rate(around);
}

}  // namespace

Guard cell_peclet(const Grid& grid, const Material& material, double burn_rate) {
    constexpr double cold = 0.02;  // of the rise: what is left below matters to nothing
    double worst = 0.0;
    double left = 1.0;
    for (int j = grid.rows() - 1; j >= 0 && std::abs(left) > cold; --j) {
        const double peclet = burn_rate * grid.height(j) / material.diffusivity();
        worst = std::max(worst, peclet);
        left *= left_below(peclet);
    }
    return no_more_than(
        "cell_peclet", worst, 2.0,
        "the rows are too high for the thermal layer, T undershoots below it; raise domain.ny");
}

double deepest_undershoot(const Scene& scene, const Grid& grid, const Material& material,
                          const SteadySlab& slab) {
    double left = slab.surface_temperature - scene.bottom.temperature;
    double lowest = 0.0;
    for (int j = grid.rows() - 1; j > 0; --j) {
        left *= left_below(slab.burn_rate * grid.height(j) / material.diffusivity());
        lowest = std::min(lowest, left);
    }
    return std::abs(lowest);
}

Guard undershoot(double kelvin) {
    constexpr double limit = 10.0;  // [K], what counts as wrong
    return no_more_than("undershoot", kelvin, limit,
                        "K below the bottom's temperature, where nothing cools; raise domain.ny "
                        "or reduce time.step");
}

std::optional<Guard> columns_in_layer(const Scene& scene, double burn_rate) {
    const Domain& d = scene.domain;
    // Measured: a sandwich on 8 columns as wide as the thermal layer, 2 of them in its strip, is 1.8 to
    // 2.4 % off, a strip of 1 that burns ten times as fast as the paper's 4.3 %; a pack with stress on
    // 2.4 across its smallest disc 3.5 %, on 4.4 2.2 %. A strip of 1 of the paper's, in columns of an
    // eighth of the layer, is 0.15 % off.
    double thinnest = d.width;
    double fewest = 3.0;
    if (const auto* const sandwich = std::get_if<Sandwich>(&scene.morphology.shape))
        thinnest = std::min(sandwich->strip, d.width - sandwich->strip);
    if (const auto* const pack = std::get_if<Discs>(&scene.morphology.shape)) {
        for (const Disc& disc : pack->discs) thinnest = std::min(thinnest, 2.0 * disc.radius);
        fewest = 5.0;
    }
    if (thinnest >= d.width) return std::nullopt;
    Guard guard{.name = "columns_in_layer",
                .value = thinnest * d.nx / d.width,
                .limit = fewest,
                .is_least = true};
    constexpr double round_off = 1e-9;
    const bool matters = std::holds_alternative<Discs>(scene.morphology.shape) ||
                         is_wide(scene, burn_rate) || strip_leads(scene);
    if (guard.value >= fewest * (1.0 - round_off) || !matters) return guard;
    guard.beyond = Beyond::remark;
    guard.text =
        fmt::format("too few for what goes across a layer or disc; raise domain.nx to {} or more",
                    2 * int(std::ceil(0.5 * fewest * d.width / thinnest)));
    return guard;
}

Guard column_peclet(const Scene& scene, const Grid& grid, const Material& m,
                    const SteadySlab& slab) {
    const double g = scene.physics.mechanics
                         ? coupling_number(coupled(m, scene.numerics), Coupling::lagged,
                                           slab.surface_temperature)
                         : 0.0;
    // Measured: binder of a thousand times its bulk modulus, 160, burns 2.3 % off beside AP and
    // converges at first order in the columns; at 2, 1 %.
    constexpr double held = 10.0;
    return no_more_than(
        "column_peclet", slab.burn_rate * narrowest_column(grid) * (1.0 + g) / m.diffusivity(),
        held,
        fmt::format("heat that enters {} from the side stays in one column, it converges slowly; "
                    "raise domain.nx or domain.clustering_x",
                    m.name));
}

Guard layers_in_window(const Scene& scene, const Material& material, double burn_rate) {
    constexpr double limit = 5.0;  // e^-5 of the rise is left at the bottom
    Guard guard{.name = "layers_in_window",
                .value = scene.domain.depth * burn_rate / material.diffusivity(),
                .limit = limit,
                .is_least = true};
    if (guard.value >= limit) return guard;
    guard.beyond = Beyond::remark;
    guard.text =
        fmt::format("the bottom cools the surface of {}; raise domain.depth to {:.4g} um or more",
                    material.name, std::ceil(1e6 * limit * material.diffusivity() / burn_rate));
    return guard;
}

double fourier_number(const Grid& grid, const Material& material, double dt) {
    const double height = lowest_row(grid);
    return material.diffusivity() * dt / (height * height);
}

Guard fourier(double number) {
    // From here on a zigzag keeps 0.9 of itself in a step and turns its sign (heat_step.hpp); in a
    // hundred steps nothing is left.
    constexpr double ringing = 9.5;
    return {.name = "fourier", .value = number, .limit = ringing};
}

Guard fourier(const Scene& scene, const Grid& grid, const Material& material) {
    constexpr double forgotten = 100.0;  // steps
    Guard guard = fourier(fourier_number(grid, material, scene.time.step));
    const bool rings = scene.time.scheme == Stepping::euler && guard.value > *guard.limit;
    if (!rings || scene.time.end / scene.time.step >= forgotten) return guard;
    guard.beyond = Beyond::remark;
    guard.text =
        "the surface rings for some 100 steps after the start, longer than this run; reduce "
        "time.step or take time.scheme = \"bdf2\"";
    return guard;
}

Guard relaxation(const Scene& scene, const Grid& grid, const Material& material) {
    if (grid.cell_columns() == 1) return relaxation(0.0, scene);
    const double width = narrowest_column(grid);
    const double share = scene.time.scheme == Stepping::bdf2 ? 2.0 / 3.0 : 0.5;
    const double a = share * material.diffusivity() * scene.time.step / (width * width);
    const double jacobi = 2.0 * a / (1.0 + 2.0 * a);
    return relaxation(jacobi * jacobi, scene);
}

Guard relaxation(double contraction, const Scene& scene) {
    constexpr double sweeps = 2000.0;  // line_relaxation.cpp allows no more
    return no_more_than("relaxation", contraction,
                        std::pow(scene.numerics.heat_tolerance, 1.0 / sweeps),
                        "the line relaxation may not converge; reduce time.step");
}

Guard pressing(const Scene& scene, const Grid& grid, const Material& material) {
    const double strain = scene.surface.pressure / material.uniaxial_modulus();
    const double cells = scene.domain.depth / lowest_row(grid);
    constexpr double linear = 0.1;  // of the depth: small strain ends there
    return no_more_than("pressing", strain * cells, linear * cells,
                        "the pressure alone squeezes the solid by more than a tenth, beyond what "
                        "small strain describes; lower surface.pressure");
}

Guard crossing_x(double cells) {
    return no_more_than("crossing_x", cells, 1.0,
                        "the solid crosses more than a column in a step; reduce time.step");
}

Guard crossing_y(double cells) {
    return no_more_than(
        "crossing_y", cells, 1.0,
        "the solid crosses more than a row in a step, and what it carries is inaccurate; reduce "
        "time.step");
}

Guard predicted_crossing_y(const Scene& scene, const Grid& grid, double burn_rate) {
    Guard guard = crossing_y(burn_rate * scene.time.mechanics_step() / lowest_row(grid));
    if (!scene.physics.mechanics || guard.beyond == Beyond::nothing) return guard;
    guard.longest_step = scene.time.step / guard.value;
    guard.text = "the solid would cross more rows in a step than stress can be carried";
    if (scene.time.mechanics_every > 1)
        guard.text +=
            fmt::format(" ({} of heat's: time.mechanics_every)", scene.time.mechanics_every);
    // A part that burns by itself may burn faster than it will beside another.
    constexpr double beyond_doubt = 1.5;
    if (guard.value > beyond_doubt) guard.beyond = Beyond::refusal;
    return guard;
}

Guard front_crossing(double columns, Stepping scheme) {
    return no_more_than("front_crossing", columns, front_crossing_limit(scheme),
                        "waves of the burning surface run too far in a step, and grow; reduce "
                        "time.step, or take fewer columns");
}

}  // namespace crawford
