#include "solver/run/burn.hpp"

#include <fmt/format.h>

#include <functional>
#include <iostream>
#include <optional>

#include "base/terminal.hpp"
#include "program/commands.hpp"
#include "solver/run/timing_table.hpp"
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
    if (outcome.chosen)
        std::cout << fmt::format(
            "steps of {:.3g} to {:.3g} us; tried again, shorter: {} for their error, {} that "
            "failed\n",
            outcome.chosen->shortest * 1e6, outcome.chosen->longest * 1e6, outcome.chosen->rejected,
            outcome.chosen->failed);
}

/// Shows on a terminal how far a run has come.
class Watch {
public:
    void operator()(const BurnProgress& at) {
        if (!line_) line_.emplace(std::cerr, stderr_is_terminal(), at.first_step);
        line_->show(at.now, at.last_step);
    }

private:
    std::optional<Progress> line_;
};

}  // namespace

int burn(const BurnSceneOptions& options, const CommandLine& command) {
    const Scene scene = read_scene(options.scene, options.set);
    const std::string name = options.scene.stem().string();
    Watch watch;
    BurnOptions files{
        .name = name,
        .directory = options.out.empty() ? std::filesystem::path("out") / name : options.out,
        .restart = options.restart,
        .command = command};
    if (!options.quiet) files.watch = std::ref(watch);
    const BurnOutcome outcome = burn(scene, files);
    if (options.timing) std::cout << timing_table(outcome.timing, outcome.seconds, outcome.steps);
    tell(outcome, files);
    return exit_code::done;
}

}  // namespace crawford
