#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "base/file_lock.hpp"
#include "cases/burn_store.hpp"
#include "program/burning.hpp"
#include "program/choose.hpp"
#include "program/commands.hpp"
#include "program/failure.hpp"
#include "program/figure_record.hpp"
#include "program/movie.hpp"
#include "program/narrator.hpp"
#include "program/pages.hpp"
#include "program/provenance.hpp"
#include "program/queue.hpp"
#include "solver/scene/write_scene.hpp"

namespace crawford {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Draws cases: first the burns that they share and those that need none, side by side, then those
/// that look at the burns.
class Run {
public:
    Run(const RunOptions& options, const CommandLine& command)
        : options_(options),
          command_(command),
          fidelity_(fidelity_of(options.fidelity)),
          narrator_(options.quiet) {
        if (options.movie) {
            movies_ = choose_movies(options.cases);
            for (const Entry& movie : movies_) chosen_.push_back(&movie);
        } else {
            chosen_ = options.all ? all_cases() : choose_cases(options.cases);
        }
        if (chosen_.empty())
            throw InputError("no case is named; crawford list shows them, --all draws them all");
        prepare_directory(figures());
    }

    int all() {
        const FileLock lock(figures() / ".lock", [this] {
            narrator_.say("waiting for another run that draws into " + figures().string());
        });
        remove_halves(figures());
        std::erase_if(chosen_, [this](const Entry* entry) { return is_up_to_date(*entry); });
        const auto failed = [this](const Job& job, const std::exception_ptr& failure) {
            tell_failure(job.name, failure);
        };
        run_told(burns_and_plain_cases(), narrator_, failed);
        run_told(cases_of_burns(), narrator_, failed);
        write_figure_pages(options_.out);
        return worst_;
    }

private:
    fs::path figures() const { return options_.out / "figures"; }

    bool is_up_to_date(const Entry& entry) {
        const auto record = read_figure_record(figures(), entry.name);
        if (options_.again || !record || !record->is_of(options_.fidelity)) return false;
        narrator_.say(fmt::format("{}: up to date", entry.name));
        tell(entry, *record);
        return true;
    }

    std::vector<Job> burns_and_plain_cases() {
        std::vector<Scene> scenes;
        for (const Entry* entry : chosen_)
            if (entry->burns)
                for (const Scene& scene : entry->burns(fidelity_)) scenes.push_back(scene);
        std::vector<Job> tasks = burnings(scenes, fidelity_, options_.out);
        for (const Entry* entry : chosen_)
            if (!entry->burns) tasks.push_back(drawing(*entry));
        return tasks;
    }

    std::vector<Job> cases_of_burns() {
        std::vector<Job> tasks;
        for (const Entry* entry : chosen_)
            if (entry->burns) tasks.push_back(drawing(*entry));
        return tasks;
    }

    Job drawing(const Entry& entry) {
        // What looks at burns that are there takes a second, whatever the burns took.
        const double cost = fidelity_ == Fidelity::draft ? entry.cost.draft : entry.cost.paper;
        return {entry.name, entry.burns ? 1.0 : cost,
                [this, &entry](const Job::Progress& progress) { draw(entry, progress); }};
    }

    void draw(const Entry& entry, const Job::Progress& progress) {
        const auto start = Clock::now();
        const Outcome outcome =
            entry.draw({.fidelity = fidelity_,
                        .out = options_.out,
                        .progress = [&](const std::string&, double done) { progress(done); }});
        FigureRecord record{.fidelity = options_.fidelity,
                            .findings = outcome.findings,
                            .pictures = outcome.figure.draw(),
                            .data = outcome.figure.data()};
        for (const Scene& scene : outcome.scenes) record.scenes.push_back(to_toml(scene));
        record.seconds = seconds_since(start);
        write(figures(), entry.name, record, provenance(command_));
        tell(entry, record);
    }

    void tell(const Entry& entry, const FigureRecord& record) {
        const std::scoped_lock lock(mutex_);
        narrator_.wipe();
        std::cout << fmt::format("{}: {}\n", entry.figure == "-" ? entry.name : entry.figure,
                                 entry.shows);
        for (const Finding& finding : record.findings)
            std::cout << fmt::format("  {:<58} {:>12.6g} {}\n", finding.what, finding.value,
                                     finding.unit);
        for (const auto& picture : record.pictures) std::cout << "  " << picture.string() << '\n';
    }

    void tell_failure(const std::string& name, std::exception_ptr exception) {
        const Failure failure = failure_of(exception);
        std::cerr << fmt::format("crawford run: {}: {}\n", name, failure.message);
        worst_ = std::max(worst_, failure.exit_code);
    }

    const RunOptions& options_;
    const CommandLine& command_;
    Fidelity fidelity_;
    Narrator narrator_;
    std::vector<Entry> movies_;
    std::vector<const Entry*> chosen_;
    std::mutex mutex_;
    int worst_ = exit_code::done;
};

}  // namespace

int run(const RunOptions& options, const CommandLine& command) {
    return Run(options, command).all();
}

}  // namespace crawford
