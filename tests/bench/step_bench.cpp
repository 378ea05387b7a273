// Seconds a step: what each kind of physics costs, and what each linear solver.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "solver/run/loop.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

using Seconds = std::map<std::string, double>;

Seconds seconds_by_module(const Simulation& simulation) {
    Seconds seconds;
    for (const ModuleTime& time : simulation.timing()) seconds[time.module] = time.seconds;
    return seconds;
}

/// Steps of a shipped scene. The first, which also analyses the matrix, is not counted.
void step(benchmark::State& state, const char* scene, const std::vector<std::string>& overrides) {
    const auto file = std::filesystem::path(CRAWFORD_SOURCE_DIR) / "cases/scenes" / scene;
    Simulation simulation(read_scene(file, overrides));
    run_steps(simulation, 1);
    Seconds before = seconds_by_module(simulation);
    for ([[maybe_unused]] auto iteration : state) run_steps(simulation, 1);
    const Grid& grid = simulation.grid();
    const double cells = double(grid.cell_columns()) * grid.rows();
    for (const auto& [module, seconds] : seconds_by_module(simulation))
        state.counters[module + "_ns_a_cell"] = benchmark::Counter(
            1e9 * (seconds - before[module]) / cells, benchmark::Counter::kAvgIterations);
    state.counters["solver_iterations"] = simulation.summary().solver_iterations;
}

std::vector<std::string> whole_sandwich(std::vector<std::string> overrides) {
    for (const char* more : {"domain.half=false", "domain.nx=128", "domain.ny=256"}) {
        overrides.emplace_back(more);
    }
    return overrides;
}

void physics(benchmark::State& state, const std::vector<std::string>& overrides) {
    step(state, "sandwich.toml", whole_sandwich(overrides));
}

void solver_sandwich(benchmark::State& state, const std::string& solver) {
    step(state, "sandwich.toml", whole_sandwich({"numerics.solver=" + solver}));
}

void solver_pack(benchmark::State& state, const std::string& solver) {
    step(state, "pack.toml", {"numerics.solver=" + solver});
}

using Overrides = std::vector<std::string>;
const Overrides coupled;
const Overrides without_map{"physics.reference_map=false"};
const Overrides mechanical{"physics.heat=false", "physics.regression=none",
                           "time.until_steady=", "physics.reference_map=false"};
const Overrides thermal{"physics.mechanics=false", "physics.reference_map=false"};

}  // namespace

BENCHMARK_CAPTURE(physics, coupled, coupled)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(physics, without_map, without_map)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(physics, mechanical, mechanical)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(physics, thermal, thermal)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(solver_sandwich, cholmod, "cholmod")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(solver_sandwich, ldlt, "ldlt")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(solver_sandwich, pcg, "pcg")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(solver_pack, cholmod, "cholmod")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(solver_pack, ldlt, "ldlt")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(solver_pack, pcg, "pcg")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace crawford
