#include "solver/guards/burning_guards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/guards/crossed.hpp"
#include "solver/guards/grid_guards.hpp"
#include "solver/heat/heat_step.hpp"

namespace crawford {

namespace {

/// z = Ea dT/(R T_s^2); zero where the rate does not hang on T_s.
double sensitivity(const Scene& scene, const Material& material, const SteadySlab& slab) {
    if (scene.physics.regression != Regression::pyrolysis) return 0.0;
    return zeldovich_number(material.activation_temperature, slab.surface_temperature,
                            scene.bottom.temperature);
}

/// Theta = q_s/(c dT)
double share_of_reaction(const Scene& scene, const Material& m, const SteadySlab& slab) {
    return m.heat_of_reaction /
           (m.specific_heat * (slab.surface_temperature - scene.bottom.temperature));
}

}  // namespace

std::optional<Guard> burning_solution(const Scene& scene, size_t number, const SlabAnswer& answer) {
    const Material& m = scene.morphology.materials[number];
    Guard guard{.name = "surface_temperature",
                .value = answer.slab.surface_temperature,
                .limit = scene.bottom.temperature,
                .is_least = true,
                .beyond = Beyond::refusal};
    if (answer.burning == Burning::too_cold) {
        guard.text = fmt::format(
            "no burning solution: as cold as the bottom, pyrolysis of {0} absorbs more than "
            "surface.heat_flux brings, so its surface would be colder; raise "
            "materials.{0}.activation_temperature or lower its pyrolysis_prefactor",
            m.name);
        return guard;
    }
    if (answer.burning == Burning::too_hot) {
        guard.limit = hottest_surface;
        guard.is_least = false;
        guard.text = fmt::format(
            "no burning solution: to carry off surface.heat_flux the surface of {} would have to "
            "be this hot; lower the flux or let it burn faster",
            m.name);
        return guard;
    }
    return std::nullopt;
}

Guard onset(const Scene& scene, const Material& m, const SteadySlab& slab) {
    const double z = sensitivity(scene, m, slab);
    Guard guard{.name = "onset",
                .value = z * share_of_reaction(scene, m, slab),
                .limit = 0.5 * (1.0 + std::sqrt(1.0 + 8.0 * z))};
    if (guard.value < *guard.limit) return guard;
    guard.beyond = Beyond::remark;
    guard.text = fmt::format(
        "the burning of {} swings and grows: so does the solid that these numbers describe, and no "
        "step or grid changes it; with less heat_of_reaction it burns steadily",
        m.name);
    return guard;
}

double front_limit(const Scene& scene, const Grid& grid, const Material& m,
                   const SteadySlab& slab) {
    const double dt = scene.time.step;
    const bool euler = scene.time.scheme == Stepping::euler;
    const double share = std::max(0.5, least_implicit(dt, stiffest_rate(grid, m.diffusivity())));
    const double bare = euler ? 2.0 : 4.0 / 3.0;
    const double layers = m.diffusivity() / (slab.burn_rate * slab.burn_rate * dt);
    const double stiff = euler ? 2.0 * layers / (2.0 * share - 1.0) : 4.0 * layers;
    if (!std::isfinite(stiff)) return bare;
    const double l = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * stiff));
    const double z = sensitivity(scene, m, slab);
    return bare * (1.0 - z * share_of_reaction(scene, m, slab) / l) / (1.0 - 1.0 / l);
}

Guard front_coupling(double number) {
    // Measured: a slab of AP has burnt 0.8 % too far in 40 ms at 0.54, 0.4 % at 0.27.
    constexpr double followed = 0.5;
    return {.name = "front_coupling", .value = number, .limit = followed};
}

double front_coupling_number(const Scene& scene, const Material& m, const SteadySlab& burning,
                             double dt) {
    return burning.burn_rate * burning.burn_rate * sensitivity(scene, m, burning) * dt /
           m.diffusivity();
}

Guard front_coupling(const Scene& scene, const Grid& grid, const Material& m,
                     const SteadySlab& slab) {
    const double stable = front_limit(scene, grid, m, slab);
    Guard guard = front_coupling(front_coupling_number(scene, m, slab, scene.time.step));
    if (guard.value <= *guard.limit) return guard;
    guard.longest_step = *guard.limit / guard.value * scene.time.step;
    if (guard.value > stable) {
        guard.limit = stable;
        guard.beyond = Beyond::refusal;
        guard.text =
            fmt::format("burn rate and surface temperature of {} would alternate and grow", m.name);
        return guard;
    }
    guard.beyond = Beyond::remark;
    guard.text =
        fmt::format("a step is long for the surface of {}, ignition is inaccurate", m.name);
    return guard;
}

Guard ignition(const Scene& scene, const Grid& grid, const Material& m, const SteadySlab& slab,
               double flux) {
    constexpr double wrong = 0.02;
    Guard guard{.name = "ignition", .limit = wrong};
    // A solid that only conducts has reached T_s under this flux after so long.
    const double layer =
        m.thermal_conductivity * (slab.surface_temperature - scene.bottom.temperature) / flux;
    const double start = 0.25 * std::numbers::pi * layer * layer / m.diffusivity();
    const double burning = scene.time.end - start;
    if (burning <= 0.0) return guard;
    // Measured on slabs of AP: 0.6 to 0.9 of a step, and 0.07 h^2 r_b/D with rows of 5 and 20 um.
    constexpr double of_a_step = 1.0, of_a_row = 0.08;
    const double height = lowest_row(grid);
    const double step = scene.time.accuracy ? 0.0 : of_a_step * scene.time.step;
    const double of_rows = of_a_row * height * height / m.diffusivity();
    guard.value = (step + of_rows) / burning;
    if (guard.value <= wrong) return guard;
    guard.beyond = Beyond::remark;
    guard.text = fmt::format(
        "of what has burnt at time.end, for {} begins to burn at {:.2g} ms in steps and rows that "
        "are coarse for so short a burn; raise domain.ny or burn longer",
        m.name, 1e3 * start);
    const double longest = (wrong * burning - of_rows) / of_a_step;
    if (step > 0.0 && longest > 0.0) guard.longest_step = longest;
    return guard;
}

Guard predicted_front_crossing(const Scene& scene, const Grid& grid, const Material& material,
                               const SteadySlab& slab) {
    constexpr double steep = 1e3;  // a front that does not hang on T may still have any slope
    const double speed = front_speed(slab.burn_rate, sensitivity(scene, material, slab), steep);
    Guard guard =
        front_crossing(speed * scene.time.step / narrowest_column(grid), scene.time.scheme);
    if (guard.beyond == Beyond::nothing) return guard;
    guard.longest_step = scene.time.step * *guard.limit / guard.value;
    guard.text = fmt::format(
        "waves of the burning surface of {} would run too far in a step, and grow", material.name);
    constexpr double beyond_doubt = 1.5;
    const bool hangs_on_t = scene.physics.regression == Regression::pyrolysis;
    if (guard.value > beyond_doubt * *guard.limit && hangs_on_t) guard.beyond = Beyond::refusal;
    return guard;
}

double predicted_slope(const Scene& scene, double regression_rate) {
    // Slower materials hang on the one that burns at the regression rate where the surface is
    // coolest: there the interface rests (docs/theory.md, "The front").
    double coolest = std::numeric_limits<double>::infinity();
    const auto temperature = [&](const Material& m) {
        return m.activation_temperature / std::log(m.pyrolysis_prefactor / regression_rate);
    };
    for (const Material& m : scene.morphology.materials)
        if (regression_rate < m.pyrolysis_prefactor) coolest = std::min(coolest, temperature(m));
    double steepest = 0.0;
    for (const Material& m : scene.morphology.materials) {
        const double own = m.pyrolysis_prefactor * std::exp(-m.activation_temperature / coolest);
        const double lead = std::max(regression_rate / own, 1.0);
        steepest = std::max(steepest, std::sqrt(lead * lead - 1.0));
    }
    return steepest;
}

Guard slope(double largest) {
    constexpr double limit = 3.0;  // what a height over columns holds
    Guard guard{.name = "slope", .value = largest, .limit = limit};
    if (largest <= limit) return guard;
    guard.beyond = Beyond::remark;
    guard.text =
        "a height over columns does not hold a surface this steep: the front does not converge "
        "with the grid; take materials that burn less unlike";
    return guard;
}

Guard alternation(double part) {
    constexpr double limit = 0.02;
    Guard guard{.name = "alternation", .value = part, .limit = limit};
    if (part <= limit) return guard;
    guard.beyond = Beyond::remark;
    guard.text = "the burn rate goes up and down from step to step; reduce time.step";
    return guard;
}

}  // namespace crawford
