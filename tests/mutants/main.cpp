/// `make mutants`: do the gates see the faults that they are there for?   (docs/mutants.md)

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <thread>

#include "hunt.hpp"
#include "report.hpp"

namespace {

using namespace crawford::mutants;
using Clock = std::chrono::steady_clock;

enum ExitCode { all_seen = 0, some_survived = 1, wrong_input = 2 };

struct Options {
    std::filesystem::path sources = CRAWFORD_SOURCE_DIR;
    std::filesystem::path work = CRAWFORD_SOURCE_DIR "/build/mutants";
    std::vector<std::string> names;
    std::vector<std::string> studies;
    bool all_studies = false;
    bool every_gate = false;
    bool check = false;
    int jobs = int(std::max(std::thread::hardware_concurrency(), 1U));
};

void say(const std::string& line) {
    std::cerr << line << std::endl;
}

std::vector<Fault> chosen(std::vector<Fault> faults, const std::vector<std::string>& names) {
    for (const std::string& name : names)
        if (std::ranges::find(faults, name, &Fault::name) == faults.end())
            throw std::invalid_argument("no fault is called " + name);
    if (!names.empty())
        std::erase_if(faults, [&](const Fault& fault) {
            return std::ranges::find(names, fault.name) == names.end();
        });
    return faults;
}

/// Why a row is worthless: it names a study that is none, or its text does not stand in its file
/// exactly once. Nothing if it is sound.
std::string problem_of(const Fault& fault, const ScratchTree& tree) {
    const auto studies = tree.studies();
    if (fault.seen_by.kind == Judge::Kind::study &&
        std::ranges::find(studies, fault.seen_by.name) == studies.end())
        return fmt::format("{}: no study is called {}", fault.name, fault.seen_by.name);
    try {
        with_fault(tree.read(fault.file), fault);
    } catch (const std::exception& problem) {
        return problem.what();
    }
    return "";
}

/// Faults that can be judged, and a verdict for each of those that cannot.
struct Sorted {
    std::vector<Fault> sound;
    std::vector<Verdict> worthless;
};

Sorted sorted(const std::vector<Fault>& faults, const ScratchTree& tree) {
    Sorted result;
    for (const Fault& fault : faults) {
        const std::string problem = problem_of(fault, tree);
        if (problem.empty())
            result.sound.push_back(fault);
        else
            result.worthless.push_back({fault, {}, problem});
    }
    return result;
}

int check(const Sorted& rows) {
    for (const Verdict& row : rows.worthless) std::cout << row.broken << '\n';
    std::cout << fmt::format("{} of {} faults apply\n", rows.sound.size(),
                             rows.sound.size() + rows.worthless.size());
    return rows.worthless.empty() ? all_seen : some_survived;
}

/// "[3 of 60, 12 min left] name: who saw it"
void tell(const Verdict& verdict, size_t done, size_t total, Clock::time_point start) {
    const auto left = (Clock::now() - start) / int(done) * int(total - done);
    const auto* killer = verdict.killer();
    const std::string fate = killer               ? killer->finding.gates.front()
                             : verdict.survived() ? "SURVIVED"
                                                  : verdict.broken;
    say(fmt::format("[{} of {}, {} min left] {}: {}", done, total,
                    std::chrono::ceil<std::chrono::minutes>(left).count(), verdict.fault.name,
                    fate));
}

int hunt(const Options& options) {
    const ScratchTree tree(options.sources, options.work / "tree");
    const auto faults =
        chosen(read_faults(options.sources / "tests" / "mutants" / "mutants.toml"), options.names);
    const Sorted rows = sorted(faults, tree);
    if (options.check) return check(rows);

    Ledger ledger(options.work / "findings.json");
    const Workshop workshop(tree.path(), options.work, options.jobs);
    Hunt hunt(tree, workshop, ledger,
              {.studies = options.studies.empty() ? tree.studies() : options.studies,
               .all_studies = options.all_studies});
    hunt.check_sound(rows.sound, say);

    std::vector<Verdict> verdicts;
    const auto start = Clock::now();
    for (const Fault& fault : rows.sound) {
        verdicts.push_back(hunt.judge(fault));
        tell(verdicts.back(), verdicts.size(), rows.sound.size(), start);
    }
    verdicts.insert(verdicts.end(), rows.worthless.begin(), rows.worthless.end());
    std::cout << table_of_faults(verdicts, options.every_gate);
    if (options.all_studies) std::cout << '\n' << table_of_judges(verdicts);
    return std::ranges::all_of(verdicts, &Verdict::killer) ? all_seen : some_survived;
}

int hunt_as_typed(int count, char** arguments) {
    Options options;
    CLI::App app{"Puts seeded faults into a copy of the sources and asks which gate sees them.",
                 "mutants"};
    app.add_option("NAME", options.names, "Faults to put in; all of the table if none is named");
    app.add_flag("--all-studies", options.all_studies, "Let every study look at every fault");
    app.add_option("--studies", options.studies, "Ask these, besides the one expected; else all")
        ->delimiter(',')
        ->allow_extra_args(false);
    app.add_flag("--all", options.every_gate, "List every gate that fell, not only the first");
    app.add_flag("--check", options.check, "Only look whether every row of the table applies");
    app.add_option("--sources", options.sources, "Working tree")->capture_default_str();
    app.add_option("--work", options.work, "Where the copy, its build and the findings go")
        ->capture_default_str();
    app.add_option("--jobs", options.jobs, "Compilers at a time")->capture_default_str();
    CLI11_PARSE(app, count, arguments);
    return hunt(options);
}

}  // namespace

int main(int count, char** arguments) {
    try {
        return hunt_as_typed(count, arguments);
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "mutants: %s\n", problem.what());
        return wrong_input;
    }
}
