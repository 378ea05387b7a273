#include "cases/catalogue/pack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <string>

#include "cases/catalogue/burns.hpp"
#include "cases/catalogue/sandwich_measures.hpp"
#include "cases/catalogue/units.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/simulation/simulation.hpp"

namespace crawford {

namespace {

using namespace units;
using Burn = std::shared_ptr<const PackBurn>;

constexpr std::array<double, 4> snapshot_parts = {35.0, 75.0, 105.0, 135.0};
constexpr double peak_interval = 0.5 * ms;

std::string name_of(const Scene& scene) {
    return fmt::format("{} pack, {:g} cal/(s cm2)",
                       scene.physics.mechanics ? "thermo-mechanical" : "thermal",
                       scene.surface.heat_flux.front() / (cal / (s * cm2)));
}

Burn burn_now(const Scene& scene, const Request& request) {
    auto burn = std::make_shared<PackBurn>();
    burn->scene = scene;
    Simulation simulation(scene);
    const long steps = std::lround(scene.time.end / scene.time.step);
    const long per_peak = std::max(1L, std::lround(peak_interval / scene.time.step));
    const std::string what = name_of(scene);
    for (long k = 1; k <= steps; ++k) {
        simulation.step();
        const double time = simulation.state().time;
        const Summary now = simulation.summary();
        burn->time.push_back(time);
        burn->mean_burn_rate.push_back(now.mean_burn_rate);
        burn->largest_temperature.push_back(now.largest_temperature);
        burn->largest_strain.push_back(now.largest_strain);
        if (scene.physics.mechanics && k % per_peak == 0) {
            const Snapshot snapshot = collect_snapshot(simulation);
            burn->peak_time.push_back(time);
            burn->peak_strain.push_back(peak(snapshot, snapshot.strain_norm, peak_radius).mean);
        }
        const double part = snapshot_parts.at(burn->snapshots.size()) / snapshot_parts.back();
        if (k == std::lround(part * double(steps)))
            burn->snapshots.push_back(collect_snapshot(simulation));
        if (request.progress) request.progress(what, double(k) / double(steps));
    }
    return burn;
}

Burn burn_pack(const Scene& scene, const Request& request) {
    static Burns<PackBurn> burns;
    return burns.get(scene, [&] { return burn_now(scene, request); });
}

}  // namespace

Scene burning_pack(Fidelity fidelity, const PackBurning& burning) {
    std::vector<std::string> overrides = {
        fmt::format("physics.mechanics={}", burning.mechanics),
        fmt::format("physics.reference_map={}", burning.mechanics)};
    switch (fidelity) {
        case Fidelity::draft:
            overrides.insert(overrides.end(), {"domain.nx=60", "domain.ny=48", "time.step=100 us",
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
    Scene scene = read_scene(reports::source_path("cases/scenes/pack.toml"), overrides);
    for (double& flux : scene.surface.heat_flux) flux *= burning.flux;
    return scene;
}

std::vector<Burn> burn_packs(const std::vector<Scene>& scenes, const Request& request) {
    std::vector<std::future<Burn>> under_way;
    for (const Scene& scene : scenes)
        under_way.push_back(
            std::async(std::launch::async, [&] { return burn_pack(scene, request); }));
    std::vector<Burn> burns;
    for (auto& burn : under_way) burns.push_back(burn.get());
    return burns;
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
