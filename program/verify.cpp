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
#include "base/file_lock.hpp"
#include "base/terminal.hpp"
#include "cases/scene_fingerprint.hpp"
#include "cases/terms.hpp"
#include "program/choose.hpp"
#include "program/chosen_grids.hpp"
#include "program/commands.hpp"
#include "program/earlier_run.hpp"
#include "program/interrupt.hpp"
#include "program/narrator.hpp"
#include "program/pages.hpp"
#include "program/provenance.hpp"
#include "reports/brief.hpp"
#include "reports/judgement.hpp"
#include "reports/junit.hpp"
#include "reports/verification.hpp"

namespace crawford {

namespace {

using Clock = std::chrono::steady_clock;

std::vector<reports::Task> tasks_of(const std::vector<ChosenStudy>& chosen,
                                    const ChosenGrids& grids) {
    std::vector<reports::Task> tasks;
    for (const ChosenStudy& one : chosen)
        tasks.push_back({one.study, grids.of(one.study), one.seconds});
    const auto has_grid = [](const reports::Task& task) {
        return !task.grids || !task.grids->empty();
    };
    if (std::ranges::none_of(tasks, has_grid))
        throw InputError(grids.typed() + ": no study has any of these grids");
    return tasks;
}

std::string command_of(const ChosenStudy& chosen, const std::vector<int>& run,
                       const ChosenGrids& grids) {
    const bool plain = chosen.name.find_first_of(" ,()'=<>;&|*\"") == std::string::npos;
    auto command = fmt::format("build/crawford verify {0}{1}{0}", plain ? "" : "'", chosen.name);
    if (grids.any() && !run.empty()) command += ' ' + grids.option(chosen.study, run);
    return command;
}

reports::Verification collected(const std::vector<ChosenStudy>& chosen,
                                std::vector<reports::StudyResult> results,
                                const VerifyOptions& options, const ChosenGrids& grids) {
    reports::Verification found;
    found.whole = options.studies.empty() && !grids.any();
    found.terms.assign(term::all.begin(), term::all.end());
    for (size_t k = 0; k < chosen.size(); ++k) {
        found.studies.push_back({.name = chosen[k].study.name(),
                                 .entry = chosen[k].entry->name,
                                 .page = opening_comment_of(*chosen[k].entry),
                                 .source = chosen[k].entry->source.string(),
                                 .command = command_of(chosen[k], results[k].grids, grids),
                                 .covers = chosen[k].study.covered(),
                                 .axis = chosen[k].study.axis(),
                                 .grids = results[k].grids,
                                 .seconds = results[k].seconds});
        std::ranges::move(results[k].gates, std::back_inserter(found.gates));
    }
    return found;
}

std::string manifest(const CommandLine& command, Clock::time_point started) {
    auto members = provenance(command);
    members["wall_seconds"] = std::chrono::duration<double>(Clock::now() - started).count();
    members["ended"] = fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr)));
    return members.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

void tell(Narrator& narrator, const reports::Progress& p) {
    narrator.say(fmt::format("{}: {} {} {:.1f} s ({} of {}, {} to go)", p.study, p.setting.text(),
                             p.failure.empty() ? "done in" : "failed after", p.seconds, p.done,
                             p.total, clock_time(p.to_go)));
}

void tell_kept(Narrator& narrator, const std::vector<reports::StudyResult>& results) {
    size_t kept = 0;
    for (const auto& result : results) kept += result.kept;
    if (kept > 0) narrator.say(fmt::format("{} runs were there, made by this very program", kept));
}

/// Where records are of another program, what is found is no verification of this one.
bool tell_foreign(const std::vector<reports::StudyResult>& results) {
    const bool is_foreign = std::ranges::any_of(results, &reports::StudyResult::is_foreign);
    if (is_foreign)
        std::cerr << "crawford: remark: records are of another build or other libraries: this "
                     "judges those, and verifies nothing of this one\n";
    return is_foreign;
}

}  // namespace

int verify(const VerifyOptions& options, const CommandLine& command) {
    const LeaveOnSignal leave(command);
    const auto chosen = choose_studies(options.studies);
    const ChosenGrids grids(options, chosen);
    const auto tasks = tasks_of(chosen, grids);
    const EarlierRun earlier(options);
    prepare_directory(options.out);
    if (options.junit) prepare_directory(absolute(*options.junit).parent_path());

    Narrator narrator(options.quiet);
    const FileLock lock(options.out / ".lock", [&] {
        narrator.say("waiting for another run that writes into " + options.out.string());
    });
    reports::RecordStore store(options.out / "records", fingerprint_with_scenes());
    const auto started = Clock::now();
    auto results =
        options.judge_only
            ? reports::judge_kept(tasks, store)
            : reports::run(
                  tasks, &store, [&](const auto& p) { tell(narrator, p); }, options.threads);
    if (!options.judge_only) tell_kept(narrator, results);
    const bool is_foreign = tell_foreign(results);
    auto found = collected(chosen, std::move(results), options, grids);
    found.whole = found.whole && !is_foreign;
    found.manifest = manifest(command, started);

    reports::write(options.out / "verify.json", found);
    if (options.junit) reports::write_junit(*options.junit, found);
    std::cout << (options.verbose ? reports::table(found.gates) : reports::brief(found)) << '\n'
              << found.summary();
    report({.out = options.out});
    const bool is_as_before = earlier.tell(found, grids.any());
    return found.fell_short() || !is_as_before ? exit_code::gate_fell_short : exit_code::done;
}

}  // namespace crawford
