#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "cases/program/blas_threads.hpp"
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

void draw(const reports::Study& study, const Results& results, const std::filesystem::path& out) {
    const auto curves = reports::curves_of(results);
    if (curves.empty()) return;
    reports::draw_convergence(file_name(study.name()), out, study.name(), curves,
                              {.revision = revision()});
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
    use_one_blas_thread();
    check_grids(options.grids);
    const auto chosen = choose_studies(options.studies);
    prepare_directory(options.out);

    Narrator narrator(options.quiet);
    Results all;
    for (const Entry* entry : chosen)
        for (const reports::Study& study : entry->studies()) {
            const Results results = run_study(study, options.grids, narrator);
            draw(study, results, options.out);
            all.insert(all.end(), results.begin(), results.end());
        }
    reports::write_json(options.out / "verify.json", all, provenance(command));
    std::cout << reports::table(all);
    return reports::all_passed(all) ? exit_code::done : exit_code::gate_fell_short;
}

}  // namespace crawford
