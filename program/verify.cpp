#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <iostream>
#include <iterator>
#include <utility>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "base/progress.hpp"
#include "cases/terms.hpp"
#include "program/choose.hpp"
#include "program/commands.hpp"
#include "program/narrator.hpp"
#include "program/pages.hpp"
#include "program/provenance.hpp"
#include "reports/judgement.hpp"
#include "reports/verification.hpp"

namespace crawford {

namespace {

using Clock = std::chrono::steady_clock;

void check_grids(const std::vector<int>& grids) {
    for (const int grid : grids)
        if (grid < 1) throw InputError(fmt::format("--grids holds {}; a grid is 1 or more", grid));
}

/// Of the study's own grids those that were asked for; if the study was named, all that were.
std::optional<std::vector<int>> grids_of(const reports::Study& study,
                                         const VerifyOptions& options) {
    if (options.grids.empty()) return {};
    if (!options.studies.empty()) return options.grids;
    auto grids = study.grids();
    std::erase_if(grids, [&](int grid) {
        return std::ranges::find(options.grids, grid) == options.grids.end();
    });
    return grids;
}

std::vector<reports::Task> tasks_of(const std::vector<ChosenStudy>& chosen,
                                    const VerifyOptions& options) {
    std::vector<reports::Task> tasks;
    for (const ChosenStudy& one : chosen)
        tasks.push_back({one.study, grids_of(one.study, options), one.seconds});
    const auto has_grid = [](const reports::Task& task) {
        return !task.grids || !task.grids->empty();
    };
    if (std::ranges::none_of(tasks, has_grid))
        throw InputError(fmt::format("--grids = {}: no study has any of these grids",
                                     fmt::join(options.grids, ",")));
    return tasks;
}

std::string command_of(const ChosenStudy& chosen, const std::vector<int>& grids, bool selected) {
    const bool plain = chosen.name.find_first_of(" ,()'=<>;&|*\"") == std::string::npos;
    auto command = fmt::format("build/crawford verify {0}{1}{0}", plain ? "" : "'", chosen.name);
    if (selected) command += fmt::format(" --grids {}", fmt::join(grids, ","));
    return command;
}

reports::Verification collected(const std::vector<ChosenStudy>& chosen,
                                std::vector<reports::StudyResult> results,
                                const VerifyOptions& options) {
    reports::Verification found;
    found.whole = options.studies.empty() && options.grids.empty();
    found.terms.assign(term::all.begin(), term::all.end());
    for (size_t k = 0; k < chosen.size(); ++k) {
        const bool selected = !options.grids.empty() && !results[k].grids.empty();
        found.studies.push_back({.name = chosen[k].study.name(),
                                 .entry = chosen[k].entry->name,
                                 .page = opening_comment_of(*chosen[k].entry),
                                 .source = chosen[k].entry->source.string(),
                                 .command = command_of(chosen[k], results[k].grids, selected),
                                 .covers = chosen[k].study.covered(),
                                 .grids = results[k].grids,
                                 .seconds = results[k].seconds});
        std::ranges::move(results[k].gates, std::back_inserter(found.gates));
    }
    return found;
}

nlohmann::ordered_json manifest(const CommandLine& command, Clock::time_point started) {
    auto members = provenance(command);
    members["wall_seconds"] = std::chrono::duration<double>(Clock::now() - started).count();
    members["ended"] = fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr)));
    return members;
}

void tell(Narrator& narrator, const reports::Progress& p) {
    narrator.say(fmt::format("{}: grid {} {} {:.1f} s ({} of {}, {} to go)", p.study, p.grid,
                             p.failure.empty() ? "done in" : "failed after", p.seconds, p.done,
                             p.total, clock_time(p.to_go)));
}

}  // namespace

int verify(const VerifyOptions& options, const CommandLine& command) {
    check_grids(options.grids);
    const auto chosen = choose_studies(options.studies);
    const auto tasks = tasks_of(chosen, options);
    prepare_directory(options.out);

    Narrator narrator(options.quiet);
    const auto started = Clock::now();
    auto results = reports::run(tasks, [&](const reports::Progress& p) { tell(narrator, p); });
    auto found = collected(chosen, std::move(results), options);
    found.manifest = manifest(command, started);

    reports::write(options.out / "verify.json", found);
    std::cout << reports::table(found.gates) << '\n' << found.summary();
    report({.out = options.out});
    return found.fell_short() ? exit_code::gate_fell_short : exit_code::done;
}

}  // namespace crawford
