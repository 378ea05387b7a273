#include "solver/run/burn.hpp"

#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "base/peak_memory.hpp"
#include "base/terminal.hpp"
#include "program/accuracy.hpp"
#include "program/burn_folder.hpp"
#include "program/burn_json.hpp"
#include "program/check.hpp"
#include "program/commands.hpp"
#include "program/interrupt.hpp"
#include "program/left_off.hpp"
#include "program/typed_scene.hpp"
#include "solver/files/checkpoint.hpp"
#include "solver/guards/predicted.hpp"
#include "solver/run/timing_table.hpp"
#include "solver/scene/write_scene.hpp"

namespace crawford {

namespace {

void add_to_manifest(const std::filesystem::path& file, const nlohmann::ordered_json& more) {
    auto manifest = nlohmann::ordered_json::parse(std::ifstream(file));
    manifest.update(more);
    write_file(file, manifest.dump(2) + '\n');
}

void tell(const BurnOutcome& outcome, const BurnOptions& files, std::ostream& words) {
    words << fmt::format(
        "{} at {:.6g} s, step {}: mean burn rate {:.5g} cm/s, regression rate {:.5g} cm/s,\n"
        "largest temperature {:.5g} K, largest strain {:.4g}\n"
        "{} steps and their output took {:.1f} s; snapshots, history, checkpoints and "
        "manifest.json are in {}\n",
        outcome.interrupted ? "interrupted"
        : outcome.steady    ? "steady"
                            : "ended",
        outcome.time, outcome.step, outcome.summary.mean_burn_rate * 100.0,
        outcome.summary.regression_rate * 100.0, outcome.summary.largest_temperature,
        outcome.summary.largest_strain, outcome.step, outcome.seconds, files.directory.string());
    if (outcome.chosen)
        words << fmt::format(
            "steps of {:.3g} to {:.3g} us; tried again, shorter: {} for their error or a row "
            "crossed, "
            "{} that failed\n",
            outcome.chosen->shortest * 1e6, outcome.chosen->longest * 1e6, outcome.chosen->rejected,
            outcome.chosen->failed);
}

/// Looks whether a preset has kept its promise, says so and leaves it in the manifest.
void tell_accuracy(const Scene& scene, const Preset& preset, const BurnOutcome& outcome,
                   const BurnOptions& files, std::ostream& words) {
    const AccuracyFound found =
        check_accuracy(scene, preset, outcome, files.directory / (files.name + "_history.csv"));
    words << fmt::format(
        "V over the second half {:.5g} cm/s, on half the grid {:.5g} cm/s: some {:.2g} % off, {:g} "
        "% "
        "promised by\npreset {}; took {:.1f} s and {:.0f} MB, and {:.1f} s to check\n",
        100.0 * found.regression_rate, 100.0 * found.coarser, 100.0 * found.error,
        100.0 * preset.error, preset.name, outcome.seconds, double(peak_memory()) / 1e6,
        found.seconds);
    add_to_manifest(files.directory / "manifest.json",
                    {{"accuracy",
                      {{"preset", preset.name},
                       {"promised", preset.error},
                       {"estimated", found.error},
                       {"regression_rate_second_half", found.regression_rate},
                       {"on_half_the_grid", found.coarser}}}});
}

/// The name goes into files that are UTF-8 by their standards.
void refuse_other_encodings(const std::string& name) {
    try {
        static_cast<void>(nlohmann::json(name).dump());
    } catch (const nlohmann::json::type_error&) {
        throw InputError("the name of the scene file is not UTF-8; rename it, say to scene.toml");
    }
}

/// What goes on where an interrupted run has left off: the same command, from its checkpoint.
std::string command_that_goes_on(const CommandLine& command, const BurnOutcome& outcome) {
    CommandLine again;
    for (size_t k = 0; k < command.size(); ++k) {
        if (command[k] == "--restart")
            ++k;
        else if (!command[k].starts_with("--restart="))
            again.push_back(command[k]);
    }
    again.insert(again.end(), {"--restart", outcome.checkpoint.string()});
    return typed(again);
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

/// A checkpoint of the scene as it is written is gone on from as it is.
Reduction reduction_of(const Scene& scene, const BurnSceneOptions& options) {
    const bool goes_on = options.restart && is_checkpoint_of(*options.restart, to_toml(scene));
    return options.as_written || goes_on ? as_written(scene) : reduced(scene);
}

struct WantedScene {
    Scene scene;
    std::optional<Preset> preset;
};

WantedScene wanted_scene(const BurnSceneOptions& options) {
    const auto preset = wanted_preset(options);
    std::vector<std::string> chosen;
    Scene scene = preset ? scene_at(options, *preset, options.quiet ? nullptr : &chosen)
                         : typed_scene(options.scene, options.set);
    for (const std::string& line : chosen) std::cerr << "crawford: " << line << '\n';
    return {std::move(scene), preset};
}

/// Fills `end` as far as it comes.
int burn_and_tell(const BurnSceneOptions& asked, const CommandLine& command, BurnEnd& end) {
    BurnSceneOptions options = asked;
    std::ostream& words = options.json ? std::cerr : std::cout;
    const auto [scene, preset] = wanted_scene(options);
    const std::string name = name_of_scene(options.scene);
    refuse_other_encodings(name);
    const std::filesystem::path folder =
        options.out.empty() ? std::filesystem::path("out") / name : options.out;
    end.out = folder;
    BurnFolder owned(folder);
    if (options.resume) {
        const LeftOff earlier =
            left_off(folder, name, scene, {to_toml(scene), to_toml(reduced(scene).scene)});
        if (earlier.is_done) {
            words << fmt::format("done before, by the same solver, in {}\n", folder.string());
            return exit_code::done;
        }
        options.restart = earlier.checkpoint;
    }
    const Reduction reduction = reduction_of(scene, options);
    refuse_results_of_others(folder, {name, options.scene, to_toml(scene), !options.out.empty()},
                             options.restart.has_value());
    refuse(predicted(reduction.scene));  // before anything of an earlier run is removed
    if (!options.restart) remove_results(folder, name);
    const Interrupt interrupt;
    Watch watch;
    BurnOptions files{.name = name,
                      .directory = folder,
                      .restart = options.restart,
                      .command = command,
                      .watch =
                          [&](const BurnProgress& at) {
                              owned.beat();
                              if (!options.quiet) watch(at);
                          },
                      .remark =
                          [&](const Guard& guard) {
                              end.remarks.push_back(guard);
                              std::cerr << "crawford: remark: " << in_words(guard) << '\n';
                          },
                      .interrupted = [&] { return interrupt.signal() != 0; }};
    if (!reduction.left_out.empty() && !options.quiet)
        std::cerr << "crawford: left out: " << reduction.left_out << "; --as-written burns all\n";
    const BurnOutcome outcome = burn(reduction, files);
    end.checkpoint = outcome.checkpoint;
    if (options.timing) words << timing_table(outcome.timing, outcome.seconds, outcome.steps);
    tell(outcome, files, words);
    if (!outcome.interrupted) {
        if (preset) tell_accuracy(scene, *preset, outcome, files, words);
        return exit_code::done;
    }
    end.goes_on_with = command_that_goes_on(command, outcome);
    words << "go on with: " << end.goes_on_with << std::endl;
    return exit_code_of(interrupt.signal());
}

}  // namespace

int burn(const BurnSceneOptions& options, const CommandLine& command) {
    BurnEnd end;
    if (options.check) return check(wanted_scene(options).scene, options.json);
    if (!options.json) return burn_and_tell(options, command, end);
    const auto started = std::chrono::steady_clock::now();
    try {
        end.exit_code = burn_and_tell(options, command, end);
    } catch (...) {
        end.failure = std::current_exception();
    }
    end.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    std::cout << json_line(end) << '\n';
    if (end.failure) std::rethrow_exception(end.failure);
    return end.exit_code;
}

}  // namespace crawford
