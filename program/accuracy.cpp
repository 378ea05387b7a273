#include "program/accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "base/errors.hpp"
#include "base/source_tree.hpp"
#include "program/told_part.hpp"
#include "program/typed_scene.hpp"
#include "solver/files/history.hpp"
#include "solver/run/loop.hpp"
#include "solver/run/reduction.hpp"

namespace crawford {

namespace {

constexpr std::array names{"draft", "paper", "fine"};

Preset preset_named(const std::string& name) {
    if (std::ranges::find(names, name) == names.end())
        throw InputError(
            fmt::format("--preset = {}; choose one of {}", name, fmt::join(names, ", ")));
    return read_preset(source_path(fmt::format("cases/scenes/presets/{}.toml", name)));
}

Preset preset_for(const std::string& accuracy) {
    const double wanted = told_part("--accuracy", accuracy, "a part of V");
    for (const Preset& preset : presets())
        if (preset.error <= wanted * (1.0 + 1e-12)) return preset;
    throw InputError(fmt::format(
        "--accuracy = {}; the finest preset promises {:g} % of V, beyond that choose domain and "
        "time.step by hand and compare two grids",
        accuracy, 100.0 * presets().back().error));
}

/// "domain.nx" of "domain.nx=32".
std::string key_of(const std::string& assignment) {
    return assignment.substr(0, assignment.find('='));
}

/// What the preset chooses beside what is set: who sets the step needs no accuracy of it.
std::vector<std::string> without_set(std::vector<std::string> keys,
                                     const std::vector<std::string>& set) {
    const auto is_set = [&](const std::string& key) {
        return std::ranges::any_of(set, [&](const auto& one) { return key_of(one) == key; });
    };
    std::erase_if(keys, [&](const std::string& one) {
        const std::string key = key_of(one);
        return is_set(key) || (key == "time.accuracy" && is_set("time.step"));
    });
    return keys;
}

/// Mean drop of the surface per time over the second half of a time [m/s].
class SecondHalf {
public:
    explicit SecondHalf(double end) : from_(0.5 * end), end_(end) {}

    void add(double before, double now, double regression_rate) {
        const double length = std::min(now, end_) - std::max(before, from_);
        if (length <= 0.0) return;
        drop_ += length * regression_rate;
        time_ += length;
    }
    double mean() const { return drop_ / time_; }

private:
    double from_, end_;
    double drop_ = 0.0, time_ = 0.0;
};

double rate_of_history(const std::filesystem::path& file, double end) {
    SecondHalf half(end);
    double before = 0.0;
    for (const HistoryRow& row : read_history(file)) {
        half.add(before, row.time, row.regression_rate);
        before = row.time;
    }
    return half.mean();
}

double rate_of_burn(const Scene& scene) {
    Simulation simulation(scene);
    SecondHalf half(scene.time.end);
    run_to_end(simulation, {[&](Simulation& now, double before) {
                   half.add(before, now.state().time, now.summary().regression_rate);
               }});
    return half.mean();
}

}  // namespace

std::vector<Preset> presets() {
    std::vector<Preset> all;
    for (const char* name : names) all.push_back(preset_named(name));
    return all;
}

std::string presets_in_words() {
    std::string lines;
    for (const Preset& preset : presets())
        lines += fmt::format("  {:<6} V to {:g} %; measured: {}\n", preset.name,
                             100.0 * preset.error, preset.measured);
    return lines;
}

std::optional<Preset> wanted_preset(const BurnSceneOptions& options) {
    if (!options.accuracy.empty()) return preset_for(options.accuracy);
    if (!options.preset.empty()) return preset_named(options.preset);
    return std::nullopt;
}

Scene scene_at(const BurnSceneOptions& options, const Preset& preset,
               std::vector<std::string>* told) {
    return typed_scene(options.scene, options.set, [&](const Scene& scene) {
        const Chosen chosen = choose(preset, scene);
        auto keys = without_set(chosen.keys, options.set);
        if (told != nullptr) {
            told->push_back(fmt::format("preset {}: {}", preset.name, fmt::join(keys, ", ")));
            told->push_back(
                fmt::format("expects V to {:g} %, some {:.2g} s on one core and {:.0f} MB",
                            100.0 * preset.error, chosen.seconds, chosen.megabytes));
            for (const std::string& beyond : chosen.outside)
                told->push_back("outside the measured range: " + beyond);
        }
        return keys;
    });
}

AccuracyFound check_accuracy(const Scene& scene, const Preset& preset, const BurnOutcome& outcome,
                             const std::filesystem::path& history) {
    const auto started = std::chrono::steady_clock::now();
    Scene again = coarser(reduced(scene).scene);
    again.time.end = outcome.time;
    again.time.until_steady.reset();
    const double coarse = rate_of_burn(again);
    const double fine = rate_of_history(history, outcome.time);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - started;
    return {.regression_rate = fine,
            .coarser = coarse,
            .error =
                std::max(preset.least_error, preset.left_of_change * std::abs(coarse / fine - 1.0)),
            .seconds = took.count()};
}

}  // namespace crawford
