#include "solver/scene/check_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/errors.hpp"

namespace crawford {

namespace {

constexpr double micrometre = 1e-6;  // [m]

template <class... Values>
void require(bool fine, fmt::format_string<Values...> message, Values&&... values) {
    if (!fine) throw InputError(fmt::format(message, std::forward<Values>(values)...));
}

void check(const Domain& d) {
    require(d.nx == 1 || d.nx >= 4,
            "domain.nx = {} is neither 1, a slab, nor at least 4, the width of the stencils", d.nx);
    require(!d.half || (d.nx % 2 == 0 && d.nx >= 8),
            "domain.nx = {} cannot be halved; domain.half = true needs an even number of cells "
            "across the whole width, at least 8",
            d.nx);
    constexpr double most_cells = 16e6;
    require(1.0 * d.nx * d.ny <= most_cells,
            "domain.nx times domain.ny = {} cells; the limit is {} cells", 1.0 * d.nx * d.ny,
            most_cells);
}

void require_even_columns(const Domain& d) {
    require(d.clustering_x == 0.0,
            "domain.clustering_x = {:g} needs a strip for the columns to cluster about, "
            "morphology.kind = \"sandwich\"; remove it",
            d.clustering_x);
}

void check(const Uniform&, const Domain& d) {
    require_even_columns(d);
}

void check(const Sandwich& shape, const Domain& d) {
    require(d.clustering_x == 0.0 || d.nx % 2 == 0,
            "domain.clustering_x = {:g} needs an even number of columns; domain.nx = {}",
            d.clustering_x, d.nx);
    const double cell = d.width / d.nx;
    require(shape.strip < d.width,
            "morphology.strip = {:.6g} um is not less than domain.width = {:.6g} um; make the "
            "strip thinner or the domain wider",
            shape.strip / micrometre, d.width / micrometre);
    const double thinnest = std::min(shape.strip, d.width - shape.strip);
    constexpr double round_off = 1e-9;
    require(
        thinnest >= cell * (1.0 - round_off),
        "morphology.strip = {:.6g} um leaves a layer of {:.6g} um, thinner than a cell of {:.6g} "
        "um; raise domain.nx = {}",
        shape.strip / micrometre, thinnest / micrometre, cell / micrometre, d.nx);
}

/// The distance of a and b, or of the nearest of b's periodic images.
double distance(const Disc& a, const Disc& b, double width, double period) {
    return std::hypot(std::remainder(a.x - b.x, width), std::remainder(a.y - b.y, period));
}

void check_overlaps(const Discs& shape, double width) {
    constexpr double touching = 1e-12;  // [m], round-off of discs that touch
    const auto& discs = shape.discs;
    for (std::size_t i = 0; i < discs.size(); ++i) {
        for (std::size_t j = i + 1; j < discs.size(); ++j) {
            const double overlap = discs[i].radius + discs[j].radius -
                                   distance(discs[i], discs[j], width, shape.period);
            require(
                overlap <= touching,
                "morphology: disc {} at ({:.6g}, {:.6g}) um and disc {} at ({:.6g}, {:.6g}) um, "
                "or their periodic images, overlap by {:.4g} um; move them apart",
                i + 1, discs[i].x / micrometre, discs[i].y / micrometre, j + 1,
                discs[j].x / micrometre, discs[j].y / micrometre, overlap / micrometre);
        }
    }
}

void check(const Discs& shape, const Domain& d) {
    constexpr std::size_t most_discs = 20000;
    require_even_columns(d);
    require(!d.half, "domain.half = true needs a symmetric scene; discs are not, remove half");
    require(d.nx > 1, "domain.nx = 1 is a slab; discs need at least 4 cells across");
    require(!shape.discs.empty() && shape.discs.size() <= most_discs,
            "morphology has {} discs; the limits are 1 and {}", shape.discs.size(), most_discs);
    const double room = std::min(d.width, shape.period);
    for (std::size_t i = 0; i < shape.discs.size(); ++i) {
        const double radius = shape.discs[i].radius;
        require(std::isfinite(radius) && radius > 0.0,
                "morphology: disc {} has the radius {} m; it must be positive", i + 1, radius);
        require(
            2.0 * radius < room,
            "morphology: disc {} with the radius {:.6g} um overlaps its own periodic image; its "
            "diameter must be less than the width {:.6g} um and the period {:.6g} um",
            i + 1, radius / micrometre, d.width / micrometre, shape.period / micrometre);
    }
    check_overlaps(shape, d.width);
}

void check(const Morphology& morphology, const Domain& domain) {
    const bool one = std::holds_alternative<Uniform>(morphology.shape);
    const std::size_t expected = one ? 1 : 2;
    const auto& materials = morphology.materials;
    require(materials.size() == expected, "morphology has {} materials; its kind needs {}",
            materials.size(), expected);
    require(one || materials[0].name != materials[1].name,
            "morphology has {} twice; use kind = \"uniform\" or name another material",
            materials[0].name);
    std::visit([&domain](const auto& shape) { check(shape, domain); }, morphology.shape);
}

/// What stands between two moves of the solid is held, and that needs a plain step of all else.
void check_turns(const Scene& scene) {
    const int every = scene.time.mechanics_every;
    if (every == 1) return;
    require(scene.physics.mechanics,
            "time.mechanics_every = {} needs physics.mechanics = true; remove it", every);
    require(
        scene.time.scheme == Stepping::euler && !scene.time.accuracy,
        "time.mechanics_every = {} needs time.scheme = \"euler\" and a time.step that is given; "
        "take them, or mechanics_every = 1",
        every);
    require(scene.morphology.indicator == Indicator::laboratory,
            "time.mechanics_every = {} needs morphology.indicator = \"laboratory\"; take it, or "
            "mechanics_every = 1",
            every);
}

void check_physics(const Scene& scene) {
    const Physics& p = scene.physics;
    require(p.heat || p.regression != Regression::pyrolysis,
            "physics.regression = \"pyrolysis\" needs the surface temperature; set physics.heat = "
            "true, or regression = \"fixed\" or \"none\"");
    require(p.mechanics || !p.reference_map,
            "physics.reference_map = true needs a velocity; set physics.mechanics = true or "
            "reference_map = false");
    require(p.reference_map || scene.morphology.indicator == Indicator::laboratory,
            "morphology.indicator = \"reference map\" needs the map; set physics.mechanics = true "
            "and reference_map = true, or indicator = \"laboratory\"");
    require(p.heat || p.mechanics || p.regression != Regression::none,
            "physics asks for nothing: heat and mechanics are false and regression is \"none\"; "
            "turn one on");
    require(p.mechanics || scene.numerics.surface_motion == SurfaceMotion::burning,
            "numerics.surface_motion = \"burning with material\" needs a velocity; set "
            "physics.mechanics = true or surface_motion = \"burning\"");
    check_turns(scene);
    require(!p.heat || scene.surface.heat_flux.size() == scene.morphology.materials.size(),
            "surface.heat_flux has {} values for {} materials; give one for each",
            scene.surface.heat_flux.size(), scene.morphology.materials.size());
    require(p.regression != Regression::fixed || scene.surface.burn_rate > 0.0,
            "surface.burn_rate = {} m/s is not positive; physics.regression = \"fixed\" needs one",
            scene.surface.burn_rate);
}

void check(const Ripple& ripple, const Domain& d) {
    require(d.nx >= 4 * ripple.waves,
            "surface.ripple.waves = {} leaves {:.3g} cells a wave; the limit is 4: raise "
            "domain.nx = {}",
            ripple.waves, 1.0 * d.nx / ripple.waves, d.nx);
    constexpr double steepest = 3.0;  // what the grid holds
    const double slope = 2.0 * std::numbers::pi * ripple.waves * ripple.amplitude / d.width;
    require(
        slope <= steepest,
        "surface.ripple has the slope {:.3g}; the limit is {:.3g}: lower its amplitude = {:.6g} "
        "um or its waves = {}",
        slope, steepest, ripple.amplitude / micrometre, ripple.waves);
    require(ripple.amplitude < 0.5 * d.depth,
            "surface.ripple.amplitude = {:.6g} um is not below half of domain.depth = {:.6g} um",
            ripple.amplitude / micrometre, d.depth / micrometre);
}

void check_modulation(const Scene& scene) {
    const FluxModulation& m = *scene.surface.modulation;
    require(scene.physics.heat,
            "surface.modulation swings the heat flux; set physics.heat = true or remove it");
    require(!scene.time.until_steady,
            "surface.modulation never lets the burn rate settle; remove it, or time.until_steady");
    constexpr double fewest_steps = 4.0;  // a period that has less is another, slower one
    const double steps = 1.0 / (m.frequency * scene.time.step);
    require(steps >= fewest_steps * (1.0 - 1e-9),
            "surface.modulation.frequency = {:.6g} Hz leaves {:.3g} steps a period; the limit is "
            "{}: reduce time.step = {} s",
            m.frequency, steps, fewest_steps, scene.time.step);
}

void check_times(const Scene& scene) {
    const Time& t = scene.time;
    require(t.end >= t.step, "time.end = {} s comes before the first step, time.step = {} s", t.end,
            t.step);
    require(!t.until_steady || scene.physics.regression == Regression::pyrolysis,
            "time.until_steady watches the burn rate, which changes only with physics.regression = "
            "\"pyrolysis\"; remove it");
    const auto not_below_step = [&t](const char* key, const std::optional<double>& every) {
        require(!every || *every >= t.step, "output.{} = {} s is less than time.step = {} s", key,
                every.value_or(0.0), t.step);
    };
    not_below_step("snapshots_every", scene.output.snapshots_every);
    not_below_step("checkpoint_every", scene.output.checkpoint_every);
}

}  // namespace

void check(const Scene& scene) {
    check(scene.domain);
    check(scene.morphology, scene.domain);
    check_physics(scene);
    check_times(scene);
    if (scene.surface.modulation) check_modulation(scene);
    if (scene.surface.ripple) check(*scene.surface.ripple, scene.domain);
}

}  // namespace crawford
