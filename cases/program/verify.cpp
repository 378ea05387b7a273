#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <future>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "cases/program/choose.hpp"
#include "cases/program/commands.hpp"
#include "cases/program/narrator.hpp"
#include "cases/program/provenance.hpp"
#include "reports/convergence_figure.hpp"
#include "reports/judgement.hpp"
#include "solver/errors.hpp"
#include "solver/output/atomic_file.hpp"
#include "solver/output/build_info.hpp"

namespace crawford {

namespace {

using Results = std::vector<reports::GateResult>;

void check_grids(const std::vector<int>& grids) {
    for (const int grid : grids)
        if (grid < 8)
            throw InputError(
                fmt::format("--grids holds {}; no study runs on fewer than 8 cells", grid));
}

/// Letters, digits and '_' only, as file names want them.
std::string file_name(const std::string& study) {
    std::string name = "verify_";
    for (const char c : study) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

bool has_point(const reports::ConvergenceCurve& curve) {
    return std::ranges::any_of(curve.convergence.levels(),
                               [](const reports::Level& level) { return level.error > 0.0; });
}

/// The convergence plot of a study, unless it reads no order or none of its runs came to an end.
void draw(const std::string& study, const Results& results, const std::filesystem::path& out) {
    const auto curves = reports::curves_of(results);
    if (std::ranges::none_of(curves, has_point)) return;
    reports::draw_convergence(file_name(study), out, study, curves, {.revision = revision()});
}

Results run_study(const reports::Study& study, const std::vector<int>& grids, Narrator& narrator) {
    return reports::run(study, grids, [&](const reports::Progress& p) {
        narrator.say(fmt::format("{}: grid {} {} {:.1f} s ({} of {})", p.study, p.grid,
                                 p.failure.empty() ? "done in" : "failed after", p.seconds, p.done,
                                 p.total));
    });
}

/// Studies run side by side, one for each core, and each its grids; results come in the catalogue's
/// order.
std::vector<Results> run_all(const std::vector<reports::Study>& studies,
                             const std::vector<int>& grids, Narrator& narrator) {
    std::vector<Results> results(studies.size());
    std::atomic<size_t> next = 0;
    const auto work = [&] {
        for (size_t k = next++; k < studies.size(); k = next++)
            results[k] = run_study(studies[k], grids, narrator);
    };
    std::vector<std::future<void>> workers;
    for (unsigned core = 0; core < std::max(std::thread::hardware_concurrency(), 1U); ++core)
        workers.push_back(std::async(std::launch::async, work));
    for (auto& worker : workers) worker.get();
    return results;
}

}  // namespace

int verify(const VerifyOptions& options, const CommandLine& command) {
    check_grids(options.grids);
    const auto chosen = choose_studies(options.studies);
    prepare_directory(options.out);

    std::vector<reports::Study> studies;
    for (const Entry* entry : chosen)
        for (const reports::Study& study : entry->studies()) studies.push_back(study);
    Narrator narrator(options.quiet);
    const std::vector<Results> results = run_all(studies, options.grids, narrator);

    Results all;
    for (const Results& part : results) all.insert(all.end(), part.begin(), part.end());
    reports::write_json(options.out / "verify.json", all, provenance(command));
    std::cout << reports::table(all) << std::flush;
    // Last, so that no result is lost where gnuplot is missing.
    for (size_t k = 0; k < studies.size(); ++k) draw(studies[k].name(), results[k], options.out);
    return reports::all_passed(all) ? exit_code::done : exit_code::gate_fell_short;
}

}  // namespace crawford
