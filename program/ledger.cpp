#include "reports/ledger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <vector>

#include "base/atomic_file.hpp"
#include "base/build_info.hpp"
#include "base/errors.hpp"
#include "base/file_lock.hpp"
#include "base/source_tree.hpp"
#include "cases/paper/ledger/ledger.hpp"
#include "program/burning.hpp"
#include "program/choose.hpp"
#include "program/commands.hpp"
#include "program/figure_record.hpp"
#include "program/interrupt.hpp"
#include "program/narrator.hpp"
#include "program/pages.hpp"
#include "program/provenance.hpp"
#include "program/queue.hpp"
#include "reports/ledger_line.hpp"

namespace crawford {

namespace {

using Clock = std::chrono::steady_clock;

/// The ledger that was settled last, as it lies in the tree.
reports::Ledger settled_before() {
    try {
        return reports::read_ledger(source_path("results/ledger.json"));
    } catch (const std::runtime_error& problem) {
        throw InputError(fmt::format("{}; crawford ledger --settle finds it anew", problem.what()));
    }
}

using Cases = std::vector<const Entry*>;

/// Whose claims are judged: those of the figures that are named, in the order of the paper, or all.
/// \throws InputError if one of them shows no claim.
Cases cases_of(const LedgerOptions& options) {
    Cases all = ledger::claiming_cases();
    if (options.figures.empty()) return all;
    const Cases named = choose_cases(options.figures);
    for (const Entry* entry : named)
        if (!entry->claims)
            throw InputError(fmt::format("no claim of the paper is judged by {}", entry->name));
    Cases cases;
    std::ranges::copy_if(all, std::back_inserter(cases), [&](const Entry* entry) {
        return std::ranges::find(named, entry) != named.end();
    });
    return cases;
}

/// A part never takes the place of the whole.
std::filesystem::path file_of(const LedgerOptions& options, const Cases& cases) {
    std::string name = "ledger";
    if (!options.figures.empty())
        for (const Entry* entry : cases) name += "-" + entry->name;
    return options.out / "figures" / (name + ".json");
}

void draw(const Cases& cases, const LedgerOptions& options, const CommandLine& command) {
    RunOptions drawing{.cases = {},
                       .fidelity = options.fidelity,
                       .out = options.out,
                       .threads = options.threads,
                       .quiet = options.quiet};
    for (const Entry* entry : cases) drawing.cases.push_back(entry->name);
    if (draw_cases(drawing, command) != exit_code::done)
        throw NumericalFailure("a case that the ledger cites could not be drawn");
}

/// Makes what has no record yet: first the burns, which runs share, then the runs, which look at
/// them.
class Runs {
public:
    Runs(Fidelity fidelity, const Cases& cases, const LedgerOptions& options,
         reports::RecordStore& store)
        : fidelity_(fidelity),
          cases_(cases),
          out_(options.out),
          threads_(options.threads),
          store_(store),
          narrator_(options.quiet) {}

    void make_missing() {
        const FileLock lock(out_ / "records" / ".ledger.lock",
                            [this] { narrator_.say("waiting for another ledger"); });
        std::vector<ledger::Run> missing;
        for (const ledger::Run& run : ledger::runs(fidelity_, cases_))
            if (!store_.find(run.experiment, run.setting)) missing.push_back(run);
        run_told(burns_of(missing), narrator_, threads_,
                 [this](const Job& job, const std::exception_ptr&) {
                     narrator_.say(job.name + " failed: its reading has no numbers");
                 });
        std::exception_ptr cannot_keep;
        run_told(jobs_of(missing), narrator_, threads_,
                 [&](const Job&, const std::exception_ptr& problem) { cannot_keep = problem; });
        if (cannot_keep) std::rethrow_exception(cannot_keep);
    }

private:
    std::vector<Job> burns_of(const std::vector<ledger::Run>& runs) const {
        std::vector<Scene> scenes;
        for (const ledger::Run& run : runs)
            scenes.insert(scenes.end(), run.scenes.begin(), run.scenes.end());
        return burnings(scenes, out_);
    }

    std::vector<Job> jobs_of(const std::vector<ledger::Run>& runs) {
        std::vector<Job> jobs;
        for (const ledger::Run& run : runs)
            jobs.push_back({run.experiment + ": " + run.setting.text(), 1.0,
                            [this, &run](const Job::Progress&) { make(run); }});
        return jobs;
    }

    void make(const ledger::Run& run) {
        store_.add(reports::record_of(run.experiment, run.setting, [&](const reports::Setting&) {
            return run.measure({.fidelity = fidelity_, .out = out_, .progress = {}});
        }));
    }

    Fidelity fidelity_;
    const Cases& cases_;
    std::filesystem::path out_;
    std::optional<unsigned> threads_;
    reports::RecordStore& store_;
    Narrator narrator_;
};

reports::Record record_of(reports::RecordStore& store, const ledger::Run& run) {
    const auto record = store.newest(run.experiment, run.setting);
    if (!record) throw std::logic_error(run.experiment + " has no record of " + run.setting.text());
    return *record;
}

double found(reports::RecordStore& store, const std::string& entry, const std::string& what) {
    const auto record = drawn_record(store, entry);
    const auto value = record ? record->found->value_of(what) : std::nullopt;
    if (!value) throw std::logic_error(fmt::format("{} has not found \"{}\"", entry, what));
    return *value;
}

reports::Ledger settle(const Cases& cases, const LedgerOptions& options,
                       const CommandLine& command) {
    const auto started = Clock::now();
    const Fidelity fidelity = fidelity_of(options.fidelity);
    draw(cases, options, command);
    prepare_directory(options.out / "records");
    auto store = figure_records(options.out);
    Runs(fidelity, cases, options, store).make_missing();
    auto settled = ledger::judged(
        fidelity, cases, [&](const ledger::Run& run) { return record_of(store, run); },
        [&](const std::string& entry, const std::string& what) {
            return found(store, entry, what);
        });
    auto manifest = provenance(command);
    manifest["fidelity"] = options.fidelity;
    manifest["source_fingerprint"] = source_fingerprint();
    manifest["wall_seconds"] = std::chrono::duration<double>(Clock::now() - started).count();
    settled.manifest =
        manifest.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    return settled;
}

/// Of which sources its numbers are. One settled before sources were noted is known by its revision.
std::string age_of(const reports::Ledger& ledger) {
    const auto manifest = nlohmann::json::parse(ledger.manifest);
    const std::string of = manifest.value("revision", "unknown");
    const std::string settled = fmt::format("settled at revision {}, fidelity {}", of,
                                            manifest.value("fidelity", "unknown"));
    const bool current = manifest.contains("source_fingerprint")
                             ? manifest.at("source_fingerprint") == source_fingerprint()
                             : of == revision();
    if (current) return settled + ", by these sources";
    return fmt::format(
        "{}; it may be stale: the sources are now at {} (make ledger settles it anew)", settled,
        revision());
}

void tell(const reports::Ledger& ledger) {
    std::cout << reports::heading_of_lines() << '\n';
    for (const auto& row : ledger.rows) std::cout << reports::line_of(row) << '\n';
    std::cout << age_of(ledger) << '\n';
}

}  // namespace

int settle_ledger(const LedgerOptions& options, const CommandLine& command) {
    const LeaveOnSignal leave(command);
    const Cases cases = cases_of(options);
    const auto ledger = options.settle ? settle(cases, options, command) : settled_before();
    const auto file = file_of(options, cases);
    reports::write(file, ledger);
    write_figure_pages(options.out);
    tell(ledger);
    std::cout << "ledger: " << file.string() << '\n';
    return exit_code::done;
}

}  // namespace crawford
