#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <set>

#include "base/atomic_file.hpp"
#include "base/build_info.hpp"
#include "base/errors.hpp"
#include "program/commands.hpp"
#include "program/ensemble_burn.hpp"
#include "program/ensemble_options.hpp"
#include "program/interrupt.hpp"
#include "program/told_part.hpp"
#include "reports/ensemble_figure.hpp"
#include "reports/ensemble_json.hpp"
#include "reports/page/ensemble.hpp"
#include "solver/scene/units.hpp"

namespace crawford {

namespace {

namespace fs = std::filesystem;

reports::EnsembleDemand demand_of(const GatherOptions& options) {
    const reports::EnsembleDemand demand{
        .interval = told_part("--interval", options.interval, "a part"),
        .confidence = told_part("--confidence", options.confidence, "a part")};
    if (demand.confidence >= 1.0)
        throw InputError(fmt::format("--confidence = {} must be below 100 %", options.confidence));
    return demand;
}

std::optional<double> after_of(const GatherOptions& options) {
    if (options.after.empty()) return {};
    try {
        const double after = read_quantity(options.after, "s");
        if (after >= 0.0) return after;
    } catch (const InputError& problem) {
        throw InputError(fmt::format("--after = \"{}\" {}", options.after, problem.what()));
    }
    throw InputError(
        fmt::format("--after = \"{}\" is before the start; give 0 s or later", options.after));
}

/// A line each; names may have blanks at their ends.
std::vector<fs::path> folders_in(const fs::path& list) {
    std::ifstream lines(list);
    if (!lines) throw InputError(fmt::format("{} cannot be read", list.string()));
    std::vector<fs::path> folders;
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) folders.emplace_back(line);
    return folders;
}

std::vector<fs::path> folders_of(const GatherOptions& options) {
    std::vector<fs::path> folders = options.folders;
    if (!options.from.empty())
        for (fs::path& folder : folders_in(options.from)) folders.push_back(std::move(folder));
    if (folders.empty())
        throw InputError("no folder is named; give one with burns, or a list with --from FILE");
    return folders;
}

/// One that is missing would leave a mean of fewer packs than was thought.
std::vector<FoundRun> found_in(const std::vector<fs::path>& folders) {
    std::vector<FoundRun> all;
    for (const fs::path& folder : folders) {
        std::vector<FoundRun> runs = found_runs(folder);
        if (runs.empty())
            throw InputError(
                fmt::format("{} has no burns; name a folder that crawford burn has written below",
                            folder.string()));
        std::ranges::move(runs, std::back_inserter(all));
    }
    return all;
}

/// A manifest that cannot be read has no place among the points: which, it does not say.
void refuse_unreadable(const std::vector<FoundRun>& runs) {
    const auto bad = std::ranges::find(runs, RunState::unreadable, &FoundRun::state);
    if (bad == runs.end()) return;
    throw InputError(bad->reason + "; burn it anew, or move it away");
}

std::vector<std::string> names_in(const fs::path& out, const std::vector<fs::path>& files) {
    std::vector<std::string> names;
    for (const fs::path& file : files) names.push_back(fs::relative(file, out).generic_string());
    return names;
}

std::vector<std::string> solvers_of(const std::vector<FoundRun>& runs) {
    std::set<std::string> found;
    for (const FoundRun& run : runs) found.insert(run.solver_fingerprint);
    return {found.begin(), found.end()};
}

/// Each kind once, with how many have it and what is said of one.
std::vector<std::string> remarks_of(const std::vector<FoundRun>& runs) {
    std::map<std::string, std::pair<long, std::string>> kinds;
    for (const FoundRun& run : runs)
        for (const auto& [name, text] : run.remarks) {
            auto& [count, example] = kinds[name];
            ++count;
            if (example.empty()) example = text;
        }
    std::vector<std::string> remarks;
    for (const auto& [name, kind] : kinds)
        remarks.push_back(fmt::format("{}, of {} burns: {}", name, kind.first, kind.second));
    return remarks;
}

/// "0.41 +- 0.02 cm/s (95 %), standard deviation 0.01, 4 of 4 packs done; for 1 %: 33 packs"
std::string in_words(const reports::EnsemblePoint& point, const reports::EnsembleDemand& demand) {
    const reports::Spread& v = point.spreads.front();
    std::string done = fmt::format("{} of {} packs done", v.count, point.burns);
    if (v.count == 0) return "not known, " + done;
    if (v.count == 1) return fmt::format("{:.5g} cm/s, {}: too few for an interval", v.mean, done);
    return fmt::format(
        "{:.5g} +- {:.2g} cm/s ({:g} %), standard deviation {:.2g}, {}; for {:g} %: {}", v.mean,
        v.half_width, 100.0 * demand.confidence, v.standard_deviation, done,
        100.0 * demand.interval,
        point.needed.front() ? fmt::format("{} packs", *point.needed.front()) : "not known");
}

void tell(const reports::Ensemble& ensemble, const fs::path& out) {
    for (const auto& point : ensemble.points) {
        const auto& c = point.conditions;
        std::cout << fmt::format("area fraction {:.4g}, {:g} MPa, {}, {} x {}: V = {}\n",
                                 c.area_fraction, 1e-6 * c.pressure, c.readings, c.columns, c.rows,
                                 in_words(point, ensemble.demand));
    }
    std::cout << fmt::format("{} and points.csv, burns.csv, ensemble.json beside it\n",
                             (out / "ensemble.html").string());
}

}  // namespace

int gather(const GatherOptions& options, const CommandLine& command) {
    const auto demand = demand_of(options);
    const auto after = after_of(options);
    const auto runs = found_in(folders_of(options));
    refuse_unreadable(runs);
    std::vector<reports::EnsembleBurn> burns;
    for (const FoundRun& run : runs) burns.push_back(ensemble_burn(run, after));
    const auto ensemble = reports::gather(std::move(burns), demand);

    const fs::path& out = options.out;
    prepare_directory(out);
    write_file(out / "points.csv", reports::points_csv(ensemble));
    write_file(out / "burns.csv", reports::burns_csv(ensemble));
    write_file(out / "ensemble.json", reports::ensemble_json(ensemble));
    const auto pictures = reports::draw_ensemble(ensemble, out, revision());
    write_file(out / "ensemble.html",
               reports::page::ensemble_page(ensemble,
                                            {.title = options.title,
                                             .pictures = names_in(out, pictures),
                                             .tables = {"points.csv", "burns.csv", "ensemble.json"},
                                             .command = typed(command),
                                             .revision = revision(),
                                             .solvers = solvers_of(runs),
                                             .remarks = remarks_of(runs)}));
    tell(ensemble, out);
    return exit_code::done;
}

}  // namespace crawford
