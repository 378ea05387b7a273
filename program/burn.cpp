#include "solver/run/burn.hpp"

#include <fmt/format.h>

#include <iostream>

#include "program/commands.hpp"
#include "solver/scene/read_scene.hpp"

namespace crawford {

namespace {

void tell(const BurnOutcome& outcome, const BurnOptions& files) {
    std::cout << fmt::format(
        "{} at {:.6g} s, step {}: mean burn rate {:.5g} cm/s, largest temperature {:.5g} K, "
        "largest strain {:.4g}\n"
        "{} steps and their output took {:.1f} s; snapshots, history, checkpoints and "
        "manifest.json are in {}\n",
        outcome.steady ? "steady" : "ended", outcome.time, outcome.step,
        outcome.summary.mean_burn_rate * 100.0, outcome.summary.largest_temperature,
        outcome.summary.largest_strain, outcome.step, outcome.seconds, files.directory.string());
}

}  // namespace

int burn(const BurnSceneOptions& options, const CommandLine& command) {
    const Scene scene = read_scene(options.scene, options.set);
    const std::string name = options.scene.stem().string();
    const BurnOptions files{
        .name = name,
        .directory = options.out.empty() ? std::filesystem::path("out") / name : options.out,
        .restart = options.restart,
        .command = command,
        .quiet = options.quiet,
        .timing = options.timing};
    tell(burn(scene, files), files);
    return exit_code::done;
}

}  // namespace crawford
