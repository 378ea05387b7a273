#include <fmt/format.h>

#include "base/build_info.hpp"
#include "cases/explore/coverage/known_records.hpp"
#include "cases/registry.hpp"

namespace crawford {

namespace {

Outcome coverage(const Request& request) {
    const auto store = records_of_values(request.out);
    std::vector<reports::KnownSeries> all;
    for (const KnownProblem& problem : known_problems(request.fidelity))
        for (auto& s : series_of(problem, *store)) all.push_back(s);
    for (const auto& s : all) {
        fmt::print("{} | {} | {}", s.name, s.order, s.truth);
        for (double v : s.values) fmt::print(" {:.3e}", v - s.truth);
        fmt::print("\n");
    }
    for (const auto& series : all)
        if (const auto why = left_out(series); !why.empty()) fmt::print("LEFT OUT {}: {}\n", series.name, why);
    std::erase_if(all, [](const auto& series) { return !left_out(series).empty(); });
    using namespace reports;
    const std::vector<std::pair<std::string, Estimator>> es{
        {"celik", [](const GridValues& g, double) { return celik_2008(g); }},
        {"roache", [](const GridValues& g, double p) { return roache(g, p); }},
        {"xing", [](const GridValues& g, double p) { return xing_stern_2010(g, p); }},
        {"eca", [](const GridValues& g, double) { return eca_hoekstra_2014(g); }}};
    for (size_t size : {3, 4})
        for (const auto& [n, e] : es)
            for (int half : {0, 1}) {
                std::vector<KnownSeries> some;
                std::vector<std::string> names;
                for (const auto& x : all) if (names.empty() || names.back() != x.problem) names.push_back(x.problem);
                for (const auto& x : all) if ((std::ranges::find(names, x.problem) - names.begin()) % 2 == half) some.push_back(x);
                const auto t = coverage_of(e, some, size);
                fmt::print("{} {:>7} half {}: problems {} quantities {} sets {} answered {:.2f} coverage {:.3f} [{:.3f},{:.3f}] held/answered {:.3f} finest {}/{} [{:.2f},{:.2f}] width {:.2f} 90% {:.1f} rel {:.2e}", size, n, half, t.problems, t.quantities, t.sets, double(t.answered)/double(t.sets), t.coverage, t.resampled.low, t.resampled.high, double(t.held)/double(t.answered), t.finest_held, t.quantities, t.binomial.low, t.binomial.high, t.median_width, t.upper_width, t.median_relative);
                for (auto& [sh, c] : t.shapes) fmt::print(" {} {}/{}/{}", name(sh), c.held, c.answered, c.sets);
                fmt::print("\n");
            }
    std::exit(0);
}

std::vector<Job> jobs(Fidelity fidelity, const std::filesystem::path& out) {
    const auto store = records_of_values(out);
    std::vector<Job> jobs;
    for (const KnownProblem& problem : known_problems(fidelity))
        for (const int grid : problem.grids)
            jobs.push_back({fmt::format("coverage, {}, {}", problem.name, grid),
                            1e-6 * double(grid) * grid * grid,
                            [=](const Job::Progress&) { keep_values(problem, grid, *store); }});
    return jobs;
}

const Registered here{{.name = "coverage",
                       .figure = "-",
                       .shows = "how often estimates of uncertainty hold the truth",
                       .cost = {.draft = 60.0, .paper = 200.0},
                       .draw = coverage,
                       .jobs = jobs}};

}  // namespace

}  // namespace crawford
