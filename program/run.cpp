#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "base/file_lock.hpp"
#include "program/burning.hpp"
#include "program/choose.hpp"
#include "program/commands.hpp"
#include "program/failure.hpp"
#include "program/figure_record.hpp"
#include "program/interrupt.hpp"
#include "program/movie.hpp"
#include "program/narrator.hpp"
#include "program/pages.hpp"
#include "program/provenance.hpp"
#include "program/queue.hpp"

namespace crawford {

namespace {

namespace fs = std::filesystem;

/// Draws cases: first the burns that they share and those that need none, side by side, then those
/// that look at the burns. Or draws them again from what they have left, and burns nothing.
class Run {
public:
    Run(const RunOptions& options, const CommandLine& command)
        : options_(options),
          command_(command),
          records_(figure_records(options.out)),
          narrator_(options.quiet) {
        if (options.movie) {
            movies_ = choose_movies(options.cases);
            for (const Entry& movie : movies_) chosen_.push_back(&movie);
        } else {
            chosen_ = options.all ? all_cases() : choose_cases(options.cases);
        }
        if (chosen_.empty())
            throw InputError("no case is named; crawford list shows them, --all draws them all");
        if (!options.from_records) fidelity_ = fidelity_of(options.fidelity);
        prepare_directory(figures());
    }

    int all() {
        const FileLock lock(figures() / ".lock", [this] {
            narrator_.say("waiting for another run that draws into " + figures().string());
        });
        remove_halves(figures());
        if (options_.from_records)
            draw_again();
        else
            draw_what_is_missing();
        write_figure_pages(options_.out);
        return worst_;
    }

private:
    fs::path figures() const { return options_.out / "figures"; }

    void draw_what_is_missing() {
        std::erase_if(chosen_, [this](const Entry* entry) { return is_up_to_date(*entry); });
        const auto failed = [this](const Job& job, const std::exception_ptr& failure) {
            tell_failure(job.name, failure);
        };
        run_told(burns_and_plain_cases(), narrator_, options_.threads, failed);
        run_told(cases_that_look_at_others(), narrator_, options_.threads, failed);
    }

    bool is_up_to_date(const Entry& entry) {
        const auto record = drawn_record(records_, entry.name);
        if (options_.again || !record || record->fingerprint != records_.fingerprint() ||
            drawn_at(*record) != options_.fidelity || !has_all_files(*record, figures()))
            return false;
        narrator_.say(fmt::format("{}: up to date", entry.name));
        tell(entry, *record);
        return true;
    }

    std::vector<Job> burns_and_plain_cases() {
        std::vector<Scene> scenes;
        for (const Entry* entry : chosen_)
            if (entry->burns)
                for (const Scene& scene : entry->burns(fidelity_)) scenes.push_back(scene);
        std::vector<Job> tasks = burnings(scenes, options_.out);
        for (const Entry* entry : chosen_) {
            if (entry->jobs)
                for (Job& job : entry->jobs(fidelity_, options_.out))
                    tasks.push_back(std::move(job));
            if (!looks_at_others(*entry)) tasks.push_back(drawing(*entry));
        }
        return tasks;
    }

    static bool looks_at_others(const Entry& entry) { return entry.burns || entry.jobs; }

    std::vector<Job> cases_that_look_at_others() {
        std::vector<Job> tasks;
        for (const Entry* entry : chosen_)
            if (looks_at_others(*entry)) tasks.push_back(drawing(*entry));
        return tasks;
    }

    Job drawing(const Entry& entry) {
        // What looks at what is there takes a second, whatever that took.
        const double cost = fidelity_ == Fidelity::draft ? entry.cost.draft : entry.cost.paper;
        return {entry.name, looks_at_others(entry) ? 1.0 : cost,
                [this, &entry](const Job::Progress& progress) { draw(entry, progress); }};
    }

    /// The old record goes first: its numbers are about to be written over. The new one comes last,
    /// so that where there is a record, all files are those it tells of.
    void draw(const Entry& entry, const Job::Progress& progress) {
        records_.forget(entry.name);
        std::exception_ptr problem;
        reports::Record record = reports::record_of(
            entry.name, at_fidelity(options_.fidelity), [&](reports::Record& found) {
                try {
                    const Outcome outcome = entry.draw(request(progress));
                    outcome.figure.draw();
                    fill(found, outcome);
                } catch (...) {
                    problem = std::current_exception();
                    throw;
                }
            });
        record.fingerprint = records_.fingerprint();
        if (!problem) write_manifest(figures(), record, provenance(command_));
        records_.add(record);
        if (problem) std::rethrow_exception(problem);
        tell(entry, record);
    }

    Request request(const Job::Progress& progress) const {
        return {.fidelity = fidelity_,
                .out = options_.out,
                .progress = [&progress](const std::string&, double done) { progress(done); }};
    }

    void draw_again() {
        std::vector<reports::Record> records;
        for (const Entry* entry : chosen_) records.push_back(redrawable(*entry));
        for (size_t k = 0; k < chosen_.size(); ++k) {
            reports::draw(*records[k].figure, fs::absolute(figures()));
            if (!fs::exists(manifest_of(figures(), chosen_[k]->name)))
                write_manifest(figures(), records[k], provenance(command_));
            tell(*chosen_[k], records[k]);
        }
    }

    /// \throws InputError if there is none, saying what to do.
    reports::Record redrawable(const Entry& entry) {
        const auto record = drawn_record(records_, entry.name);
        const auto refuse = [&](const std::string& why) {
            throw InputError(
                fmt::format("{}: {}; draw it first, without --from-records", entry.name, why));
        };
        const auto place = options_.out / "records" / reports::record_file_name(entry.name);
        if (!record) refuse(fmt::format("no record of a drawing in {}", place.string()));
        if (!options_.fidelity.empty() && drawn_at(*record) != options_.fidelity)
            refuse(fmt::format("the record is of fidelity {}, not {}", drawn_at(*record),
                               options_.fidelity));
        if (!record->figure->keeps_numbers) refuse("the numbers of a movie are not kept beside it");
        if (const auto missing = missing_data(*record, figures()); !missing.empty())
            refuse(missing.front().string() + " is gone");
        return *record;
    }

    void tell(const Entry& entry, const reports::Record& record) {
        const std::scoped_lock lock(mutex_);
        narrator_.wipe();
        std::cout << fmt::format("{}: {}\n", entry.figure == "-" ? entry.name : entry.figure,
                                 entry.shows);
        for (const Finding& finding : findings_of(record))
            std::cout << fmt::format("  {:<58} {:>12.6g} {}\n", finding.what, finding.value,
                                     finding.unit);
        for (const auto& picture : record.figure->pictures())
            std::cout << "  " << fs::absolute(figures() / picture).string() << '\n';
    }

    void tell_failure(const std::string& name, const std::exception_ptr& exception) {
        const Failure failure = failure_of(exception);
        std::cerr << fmt::format("crawford run: {}: {}\n", name, failure.message);
        worst_ = std::max(worst_, failure.exit_code);
    }

    const RunOptions& options_;
    const CommandLine& command_;
    Fidelity fidelity_ = Fidelity::paper;
    reports::RecordStore records_;
    Narrator narrator_;
    std::vector<Entry> movies_;
    std::vector<const Entry*> chosen_;
    std::mutex mutex_;
    int worst_ = exit_code::done;
};

}  // namespace

int run(const RunOptions& options, const CommandLine& command) {
    const LeaveOnSignal leave(command);
    return draw_cases(options, command);
}

int draw_cases(const RunOptions& options, const CommandLine& command) {
    return Run(options, command).all();
}

}  // namespace crawford
