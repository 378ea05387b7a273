#include "cases/explore/tradeoff/trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace crawford::tradeoff {

namespace {

using Changes = std::vector<std::string>;

/// A knob and what it is turned to.
struct Knob {
    std::string name;
    std::vector<Changes> positions;
};

std::vector<Changes> each(const std::string& key, const Changes& values) {
    std::vector<Changes> positions;
    for (const std::string& value : values) positions.push_back({fmt::format("{}={}", key, value)});
    return positions;
}

Changes grid(int columns, int rows) {
    return {fmt::format("domain.nx={}", columns), fmt::format("domain.ny={}", rows)};
}

Changes operator+(Changes a, const Changes& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

Changes fixed(const std::string& step) {
    return {"time.step=" + step};
}

Changes chosen(const std::string& accuracy) {
    return {"time.step=auto", "time.accuracy=" + accuracy};
}

const Knob steps_by_themselves{"step, by itself",
                               {chosen("1e-2"), chosen("3e-3"), chosen("1e-3"), chosen("1e-4")}};

std::vector<Knob> of_heat() {
    return {{"clustering of rows", each("domain.clustering", {"0", "1", "3"})},
            {"heat tolerance", each("numerics.heat_tolerance", {"1e-6", "1e-4", "1e-3"})},
            {"scheme",
             {{"time.scheme=bdf2"},
              Changes{"time.scheme=bdf2"} + fixed("160 us"),
              Changes{"time.scheme=bdf2"} + chosen("1e-3")}},
            {"front", {{"numerics.front=mean of materials"}}},
            steps_by_themselves};
}

std::vector<Knob> of_stress() {
    return {{"element", {{"numerics.element=q1"}}},
            {"coupling", {{"numerics.coupling=lagged"}}},
            {"linear solver", {{"numerics.solver=ldlt"}}},
            {"mechanics every", each("time.mechanics_every", {"2", "4", "8"})},
            {"reference map", {{"physics.reference_map=false"}}},
            {"physics", {{"physics.mechanics=false", "physics.reference_map=false"}}}};
}

/// Coarse and fine in all ways at once.
Knob of_sandwich_together() {
    Knob together{"several at once", {}};
    for (const auto& [columns, rows] : {std::pair{8, 24}, {16, 24}, {16, 48}, {32, 48}, {32, 96}})
        for (const char* accuracy : {"1e-2", "1e-3"})
            together.positions.push_back(grid(columns, rows) + chosen(accuracy));
    for (const int columns : {16, 32, 64})
        together.positions.push_back(grid(columns, 96) + Changes{"domain.clustering_x=2"} +
                                     chosen("1e-3"));
    together.positions.push_back(grid(32, 48) + Changes{"domain.clustering_x=2"} + chosen("1e-3"));
    return together;
}

std::vector<Knob> of_sandwich() {
    std::vector<Knob> knobs = of_heat();
    const std::vector<Knob> own{
        {"columns", each("domain.nx", {"16", "32", "128"})},
        {"rows", each("domain.ny", {"24", "48", "192"})},
        {"clustering of columns", each("domain.clustering_x", {"1", "2", "3"})},
        {"step", each("time.step", {"20 us", "80 us", "160 us"})},
        {"half", {{"domain.half=false"}}},
        of_sandwich_together()};
    knobs.insert(knobs.end(), own.begin(), own.end());
    return knobs;
}

std::vector<Knob> of_pack() {
    Knob together{"several at once", {}};
    for (const auto& [columns, rows] : {std::pair{30, 24}, {40, 32}, {60, 48}, {120, 96}})
        for (const char* accuracy : {"1e-2", "1e-3"})
            together.positions.push_back(grid(columns, rows) + chosen(accuracy));
    std::vector<Knob> knobs = of_heat();
    const std::vector<Knob> own{
        {"columns", each("domain.nx", {"30", "120"})},
        {"rows", each("domain.ny", {"24", "96"})},
        {"step", each("time.step", {"50 us", "200 us"})},
        // The paper's; a sandwich of 2,000 steps would take an hour.
        {"solver tolerance",
         {{"numerics.solver=pcg"}, {"numerics.solver=pcg", "numerics.solver_tolerance=1e-4"}}},
        together};
    knobs.insert(knobs.end(), own.begin(), own.end());
    return knobs;
}

std::vector<Knob> of_slab() {
    return {{"rows", each("domain.ny", {"8", "16", "32", "128", "256"})},
            {"clustering of rows", each("domain.clustering", {"0", "1", "3"})},
            {"step", each("time.step", {"20 us", "80 us", "160 us", "320 us"})},
            {"scheme", {{"time.scheme=bdf2"}, Changes{"time.scheme=bdf2"} + fixed("160 us")}},
            steps_by_themselves};
}

void add(std::vector<Trial>& trials, const std::string& subject, const std::vector<Knob>& knobs) {
    trials.push_back({subject, "as it is", {}});
    for (const Knob& knob : knobs)
        for (const Changes& position : knob.positions)
            trials.push_back({subject, knob.name, position});
}

/// What the others of a subject are held against.
void add_truth(std::vector<Trial>& trials, const std::string& subject, const Changes& finest,
               const Changes& fine) {
    trials.push_back({subject, "check of the truth", fine});
    trials.push_back({subject, "truth", finest});
}

void add_truths(std::vector<Trial>& trials, bool quick) {
    const Changes clustered{"domain.clustering_x=2"};
    if (quick) {
        add_truth(trials, "sandwich", grid(64, 96) + clustered + chosen("3e-4"),
                  grid(32, 48) + clustered + chosen("1e-3"));
        add_truth(trials, "pack", grid(60, 48) + chosen("3e-4"), grid(30, 24) + chosen("1e-3"));
        return;
    }
    add_truth(trials, "sandwich", grid(128, 192) + clustered + fixed("20 us"),
              grid(64, 96) + clustered + fixed("40 us"));
    add_truth(trials, "pack", grid(240, 192) + chosen("3e-4"), grid(120, 96) + chosen("1e-3"));
}

/// A look leaves out what takes longer than the setting that knobs are turned about.
bool is_quick(const Trial& trial) {
    for (const char* slow : {"domain.nx=128", "domain.ny=192", "domain.nx=120", "time.step=20 us",
                             "time.accuracy=1e-4", "numerics.solver=pcg", "domain.half=false"})
        if (std::ranges::find(trial.changes, slow) != trial.changes.end()) return false;
    return trial.subject != "pack" ||
           std::ranges::find(trial.changes, "domain.ny=96") == trial.changes.end();
}

}  // namespace

std::vector<Subject> subjects(Fidelity fidelity) {
    const bool quick = fidelity == Fidelity::draft;
    const Changes rigid{"physics.mechanics=false", "physics.reference_map=false"};
    const Changes sandwich =
        (quick ? grid(32, 48) : grid(64, 96)) + Changes{"time.until_steady=", "time.step=40 us"};
    const auto until = [](const char* end) { return Changes{std::string("time.end=") + end}; };
    return {
        {"slab", "slab.toml",
         Changes{"time.step=40 us", "domain.ny=64", "physics.regression=pyrolysis",
                 "materials.AP.heat_of_reaction="} +
             until("160 ms"),
         140e-3, 160e-3, 0},
        {"sandwich, rigid", "sandwich.toml", sandwich + rigid + until("80 ms"), 60e-3, 80e-3, 64},
        {"sandwich", "sandwich.toml", sandwich + until(quick ? "20 ms" : "80 ms"),
         quick ? 10e-3 : 60e-3, quick ? 20e-3 : 80e-3, 64},
        {"pack", "pack.toml",
         grid(60, 48) + Changes{"time.step=100 us"} + until(quick ? "12 ms" : "30 ms"),
         quick ? 6e-3 : 10e-3, quick ? 12e-3 : 30e-3, 120}};
}

std::vector<Trial> trials(Fidelity fidelity) {
    const bool quick = fidelity == Fidelity::draft;
    std::vector<Trial> trials;
    add_truths(trials, quick);
    const size_t truths = trials.size();
    add(trials, "slab", of_slab());
    add(trials, "sandwich, rigid", of_sandwich());
    const std::vector<Knob> stress = of_stress();
    std::vector<Knob> coupled = of_sandwich();
    coupled.insert(coupled.end(), stress.begin(), stress.end());
    add(trials, "sandwich", coupled);
    std::vector<Knob> pack = of_pack();
    pack.insert(pack.end(), stress.begin(), stress.end());
    add(trials, "pack", pack);
    if (quick)
        trials.erase(std::remove_if(trials.begin() + std::ptrdiff_t(truths), trials.end(),
                                    [](const Trial& trial) { return !is_quick(trial); }),
                     trials.end());
    return trials;
}

}  // namespace crawford::tradeoff
