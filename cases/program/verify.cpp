#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iostream>
#include <nlohmann/json.hpp>
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

}  // namespace

int verify(const VerifyOptions& options, const CommandLine& command) {
    check_grids(options.grids);
    const auto chosen = choose_studies(options.studies);
    prepare_directory(options.out);

    Narrator narrator(options.quiet);
    std::vector<std::pair<std::string, Results>> studies;
    Results all;
    for (const Entry* entry : chosen)
        for (const reports::Study& study : entry->studies()) {
            studies.emplace_back(study.name(), run_study(study, options.grids, narrator));
            const Results& results = studies.back().second;
            all.insert(all.end(), results.begin(), results.end());
        }
    reports::write_json(options.out / "verify.json", all, provenance(command));
    std::cout << reports::table(all) << std::flush;
    // Last, so that no result is lost where gnuplot is missing.
    for (const auto& [study, results] : studies) draw(study, results, options.out);
    return reports::all_passed(all) ? exit_code::done : exit_code::gate_fell_short;
}

}  // namespace crawford
