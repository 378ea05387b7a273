#include "cases/scenes/pack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/source_tree.hpp"
#include "solver/scene/read_scene.hpp"

namespace crawford {

namespace {

constexpr std::array<double, 4> snapshot_parts = {35.0, 75.0, 105.0, 135.0};
/// Checkpoints, which snapshots are taken from, divide the time so that each of them is one.
constexpr double checkpoints = 27.0;

}  // namespace

Scene burning_pack(Fidelity fidelity, const PackBurning& burning) {
    std::vector<std::string> overrides = {
        fmt::format("physics.mechanics={}", burning.mechanics),
        fmt::format("physics.reference_map={}", burning.mechanics)};
    switch (fidelity) {
        case Fidelity::draft:
            overrides.insert(overrides.end(), {"domain.nx=60", "domain.ny=48", "time.step=50 us",
                                               "time.end=0.081 s"});
            break;
        case Fidelity::paper:
            overrides.insert(overrides.end(), {"domain.nx=120", "domain.ny=96", "time.step=25 us",
                                               "time.end=0.135 s"});
            break;
        case Fidelity::fine:
            overrides.insert(overrides.end(), {"domain.nx=160", "domain.ny=128", "time.step=20 us",
                                               "time.end=0.135 s"});
    }
    Scene scene = read_scene(source_path("cases/scenes/pack.toml"), overrides);
    for (double& flux : scene.surface.heat_flux) flux *= burning.flux;
    if (burning.flux != 1.0) scene.title += fmt::format(", {:g} times the flux", burning.flux);
    const bool filmed = burning.mechanics && burning.flux == 1.0;
    scene.output = {.checkpoint_every = filmed ? filmed_every : scene.time.end / checkpoints};
    return scene;
}

std::vector<Snapshot> four_times(const Burn& burn) {
    std::vector<Snapshot> snapshots;
    for (const double part : snapshot_parts)
        snapshots.push_back(burn.at(part / snapshot_parts.back() * burn.scene.time.end));
    return snapshots;
}

Course course(const std::vector<double>& time, const std::vector<double>& values) {
    double sum = 0.0, squares = 0.0;
    int count = 0;
    for (size_t k = 0; k < time.size(); ++k) {
        if (time[k] < burning_since) continue;
        sum += values[k];
        squares += values[k] * values[k];
        ++count;
    }
    const double mean = sum / count;
    return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

}  // namespace crawford
