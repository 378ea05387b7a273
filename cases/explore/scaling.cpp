/// # Scaling: what does a step cost as the grid grows?
///
/// The paper's sandwich, whole, with stress, heat and reference map, on ever finer grids: CPU seconds a
/// step of the whole program and the largest memory, against the unknowns of the projection. CHOLMOD is the
/// default; Jacobi-PCG at 1e-8 is the paper's. Each is burnt by itself, one after the other. A solver is not
/// tried on the next grid where its step, grown as unknowns^1.5, would take longer than a time that is set
/// beforehand: its line ends there.
///
/// The second question is what a solver's work hangs on besides the grid: iterations of one projection, where
/// the shear modulus of the strip falls to a part of that around it (K/mu the same in both), and where both
/// become incompressible (K/mu the same in both, mu alike). A direct solver has none to count, and takes
/// the same time.
///
/// What not to conclude. Seconds are those of one core of one machine; their exponent is what carries over.
/// It is a fit over grids of the default solver's own range, and an exponent of a factorisation in the plane
/// is bound to rise to 1.5 in the end.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/build_info.hpp"
#include "base/peak_memory.hpp"
#include "base/source_tree.hpp"
#include "base/thread_time.hpp"
#include "cases/registry.hpp"
#include "cases/scene_fingerprint.hpp"
#include "cases/units.hpp"
#include "reports/order.hpp"
#include "reports/record_store.hpp"
#include "solver/run/loop.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/scene/write_scene.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

using namespace units;

constexpr auto experiment = "scaling, steps";
constexpr auto seconds = "CPU seconds a step";
constexpr auto iterations = "iterations a step";
constexpr auto unknowns = "unknowns";

struct Trial {
    std::string of;  ///< "grid", "shear" or "bulk"
    std::string solver;
    int columns, rows;
    double contrast = 1.0;
};

/// The paper's, whole, by a solver on a grid.
Scene sandwich(const Trial& trial) {
    return read_scene(source_path("cases/scenes/sandwich.toml"),
                      {"domain.half=false", fmt::format("domain.nx={}", trial.columns),
                       fmt::format("domain.ny={}", trial.rows),
                       "time.until_steady=", "time.end=1 ms", "numerics.solver=" + trial.solver});
}

/// K/mu of AP, by which neither material is near incompressible.
constexpr double compressible = 1.2;

Scene scene_of(const Trial& trial) {
    Scene scene = sandwich(trial);
    if (trial.of == "grid") return scene;
    auto& materials = scene.morphology.materials;
    const double stiff = std::max(materials[0].shear_modulus, materials[1].shear_modulus);
    for (Material& material : materials) {
        const bool is_soft = trial.of == "shear" && material.shear_modulus < stiff;
        material.shear_modulus = is_soft ? stiff / trial.contrast : stiff;
        material.bulk_modulus =
            material.shear_modulus * (trial.of == "bulk" ? trial.contrast : compressible);
        material.thermal_expansion = 1e-6;  // no coupling: only the projection is asked
    }
    return scene;
}

void fill(reports::Record& record, const Trial& trial) {
    const Scene scene = scene_of(trial);
    record.scenes = {to_toml(scene)};
    Simulation simulation(scene);
    const bool is_of_grids = trial.of == "grid";
    if (is_of_grids) run_steps(simulation, 1);  // which also analyses the matrix
    const int timed = is_of_grids ? 2 : 1;
    const double before = seconds_of_this_thread();
    run_steps(simulation, timed);
    record.found = reports::Measurement();
    record.found->value(unknowns, 2.0 * trial.columns * (trial.rows + 1))
        .value(iterations, simulation.solver_iterations())
        .value(seconds, (seconds_of_this_thread() - before) / timed);
}

reports::Record record_of(const Trial& trial, reports::RecordStore& store) {
    const auto setting = reports::Setting()
                             .set("of", trial.of)
                             .set("numerics.solver", trial.solver)
                             .set("domain.nx", long(trial.columns))
                             .set("domain.ny", long(trial.rows))
                             .set("contrast", reports::Amount{trial.contrast, "-"});
    if (const auto kept = store.find(experiment, setting)) return *kept;
    forget_peak_memory();
    reports::Record made = reports::record_of(
        experiment, setting, [&](reports::Record& record) { fill(record, trial); });
    store.add(made);
    return made;
}

/// One series of a picture.
struct Line {
    std::vector<double> x, seconds, megabytes, iterations;

    void add(double at, const reports::Record& record) {
        x.push_back(at);
        seconds.push_back(record.found->value_of(crawford::seconds).value());
        megabytes.push_back(double(record.cost.peak_memory_bytes) / 1e6);
        iterations.push_back(record.found->value_of(crawford::iterations).value());
    }
};

/// p of y ~ x^p, of the points from x = `least` to `most`.
double exponent(const Line& line, const std::vector<double>& y, double least, double most) {
    std::vector<double> within, values;
    for (size_t k = 0; k < line.x.size(); ++k) {
        if (line.x[k] < least || line.x[k] > most) continue;
        within.push_back(line.x[k]);
        values.push_back(y[k]);
    }
    return reports::slope_of_logarithms(within, values);
}

Line over_grids(const std::string& solver, const std::vector<std::pair<int, int>>& grids,
                double longest, reports::RecordStore& store, const Request& request) {
    Line line;
    for (const auto& [columns, rows] : grids) {
        const double size = 2.0 * columns * (rows + 1);
        constexpr double growth = 1.5;
        if (!line.x.empty() &&
            line.seconds.back() * std::pow(size / line.x.back(), growth) > longest)
            break;
        const reports::Record record = record_of({"grid", solver, columns, rows}, store);
        if (!record.ending.is_done()) break;
        line.add(size, record);
        if (request.progress)
            request.progress("scaling", double(line.x.size()) / double(grids.size()));
    }
    return line;
}

Line over_contrasts(const std::string& of, int decades, int columns, reports::RecordStore& store) {
    Line line;
    for (int decade = 0; decade <= decades; ++decade) {
        const double contrast = std::pow(10.0, decade);
        const reports::Record record =
            record_of({of, "pcg", columns, 2 * columns, contrast}, store);
        if (!record.ending.is_done()) break;
        line.add(contrast, record);
    }
    return line;
}

void add(reports::Figure& figure, const std::string& name, const Line& line) {
    figure.table(name, {{"unknowns or contrast", "-", line.x},
                        {seconds, "s", line.seconds},
                        {"memory", "MB", line.megabytes},
                        {iterations, "-", line.iterations}});
}

Outcome scaling(const Request& request) {
    const bool is_draft = request.fidelity == Fidelity::draft;
    reports::RecordStore store(request.out / "records", fingerprint_with_scenes());
    std::vector<std::pair<int, int>> grids{{32, 64}, {64, 64}, {64, 128}, {128, 128}, {128, 256}};
    if (!is_draft) grids.insert(grids.end(), {{256, 256}, {256, 512}, {512, 512}, {512, 1024}});
    const double longest = is_draft ? 5.0 : 60.0;
    const Line direct = over_grids("cholmod", grids, longest, store, request);
    const Line iterative = over_grids("pcg", grids, longest, store, request);
    const int columns = is_draft ? 16 : 64;
    const Line shear = over_contrasts("shear", 8, columns, store);
    const Line bulk = over_contrasts("bulk", 5, columns, store);

    reports::Figure figure("scaling", request.out);
    add(figure, "cholmod", direct);
    add(figure, "pcg", iterative);
    add(figure, "shear", shear);
    add(figure, "bulk", bulk);
    // From 64 x 64 to 512 x 512, as they are there.
    constexpr double from = 2.0 * 64 * 65, to = 2.0 * 512 * 513;
    const double of_direct = exponent(direct, direct.seconds, from, to);
    const double of_iterative = exponent(iterative, iterative.seconds, from, to);
    const double of_memory = exponent(direct, direct.megabytes, from, to);
    for (const char* panel : {"a", "b", "c"})
        figure.panel(panel, reports::Format::svg, {.width = 640, .height = 460});
    figure.set("exponent_cholmod", of_direct)
        .set("exponent_pcg", of_iterative)
        .set("columns", double(columns))
        .caption({.grid = "each point has its own",
                  .revision = revision(),
                  .note = "CPU seconds of one core, one burn at a time"});
    Outcome outcome{figure, {}, {}};
    outcome.findings = {{"CHOLMOD: seconds a step as unknowns to the power", of_direct, "-"},
                        {"CHOLMOD: memory likewise", of_memory, "-"},
                        {"Jacobi-PCG: seconds a step as unknowns to the power", of_iterative, "-"}};
    const size_t last = iterative.x.size() - 1;
    outcome.findings.push_back(
        {fmt::format("Jacobi-PCG over CHOLMOD, {:.0f} unknowns", iterative.x[last]),
         iterative.seconds[last] / direct.seconds[last], "times"});
    outcome.findings.push_back(
        {fmt::format("Jacobi-PCG, iterations at mu ratio {:g}", shear.x.back()),
         shear.iterations.back(), "-"});
    outcome.findings.push_back({fmt::format("Jacobi-PCG, iterations at K/mu {:g}", bulk.x.back()),
                                bulk.iterations.back(), "-"});
    return outcome;
}

const Registered here{{.name = "scaling",
                       .figure = "-",
                       .shows = "what a step costs as the grid and the contrasts grow",
                       .physics = {physics::grid, physics::sandwich, physics::coupling},
                       .cost = {.draft = 20.0, .paper = 400.0},
                       .draw = scaling}};

}  // namespace

}  // namespace crawford
