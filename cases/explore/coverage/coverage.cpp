/// # Coverage: which estimate of uncertainty can be believed?
///
/// An estimate says: the value on the finest grid is off by no more than this. Here the truth is
/// known, of temperatures, stresses, displacements, velocities, surface heights, burn rates at
/// single places of the problems that the studies solve. From the grids of each series every three
/// and every four are taken, coarse ones too, of ratios from 1.3 to 8, and each estimate is asked.
///
/// Counted is how often its interval, as its source defines it, holds the truth; what it declines to
/// answer it does not hold. Each quantity counts alike. Beside it stands how wide the interval is, in
/// true errors of the finest grid.
///
/// The default is chosen on one half of the problems and reported on the other (tally.hpp). Sets of
/// one quantity share grids, and quantities of one problem share runs: intervals of a share come
/// from resampling whole problems. Beside them stands the plain binomial interval over quantities,
/// one set each, that of the finest grids.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>

#include "base/build_info.hpp"
#include "cases/explore/coverage/known_records.hpp"
#include "cases/explore/coverage/tally.hpp"
#include "cases/explore/coverage/tally_json.hpp"
#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "reports/default_estimate.hpp"

namespace crawford {

namespace {

using reports::at_least;
using reports::at_most;

using Series = std::vector<reports::KnownSeries>;

Series kept_series(Fidelity fidelity, reports::RecordStore& store) {
    Series all;
    for (const KnownProblem& problem : known_problems(fidelity))
        std::ranges::move(series_of(problem, store), std::back_inserter(all));
    return all;
}

/// Points of the picture: estimates in their order, the choosing half, then the other.
void add_panel(reports::Figure& figure, const std::vector<TalliedEstimate>& tallied,
               std::size_t grids, const std::string& name) {
    reports::Column estimate{"estimate", "-", {}}, half{"half", "-", {}}, share{"held", "%", {}},
        low{"low", "%", {}}, high{"high", "%", {}}, width{"median half-width", "true errors", {}};
    double number = 0.0, last = 0.0;
    for (const TalliedEstimate& t : tallied) {
        if (t.grids != grids) continue;
        ++number;
        if (t.choosing.answered == 0) continue;
        last = number;
        for (const auto* side : {&t.choosing, &t.reporting}) {
            estimate.values.push_back(number);
            half.values.push_back(side == &t.choosing ? 1.0 : 2.0);
            share.values.push_back(100.0 * side->coverage);
            low.values.push_back(100.0 * side->resampled.low);
            high.values.push_back(100.0 * side->resampled.high);
            width.values.push_back(side->median_width);
        }
        figure.set(fmt::format("estimate_{:.0f}", number), t.name);
    }
    figure.set("last_" + name, last);
    figure.table(name, {estimate, half, share, low, high, width})
        .panel(name, reports::Format::svg, {.width = 760, .height = 480});
}

std::vector<Finding> findings_of(const std::vector<TalliedEstimate>& tallied) {
    std::vector<Finding> all;
    for (const TalliedEstimate& t : tallied) {
        const std::string of = fmt::format("{}, {} grids, ", t.name, t.grids);
        all.push_back({of + "held, choosing half", 100.0 * t.choosing.coverage, "%"});
        all.push_back({of + "held, reporting half", 100.0 * t.reporting.coverage, "%"});
        if (t.reporting.answered == 0) continue;
        all.push_back(
            {of + "median half-width, reporting half", t.reporting.median_width, "true errors"});
    }
    return all;
}

Outcome coverage(const Request& request) {
    const auto store = records_of_values(request.out);
    const Series all = kept_series(request.fidelity, *store);
    const std::vector<TalliedEstimate> tallied = tally(halves_of(all));
    reports::Figure figure("coverage", request.out);
    add_panel(figure, tallied, 3, "three");
    add_panel(figure, tallied, 4, "four");
    figure.other("json", "../coverage.json", json_of(all, tallied))
        .caption(
            {.revision = revision(),
             .note = "open: the half to choose on, full: the other; bars: 95 % of resamplings"});
    return {figure, findings_of(tallied), {}};
}

std::vector<Job> jobs(Fidelity fidelity, const std::filesystem::path& out) {
    const auto store = records_of_values(out);
    std::vector<Job> jobs;
    for (const KnownProblem& problem : known_problems(fidelity))
        for (const int grid : problem.grids) {
            const double cells = double(grid) * grid;
            jobs.push_back({fmt::format("coverage, {}, grid {}", problem.name, grid),
                            problem.kind == "coupled" ? 5e-5 * cells * grid : 1e-4 * cells,
                            [=](const Job::Progress&) { keep_values(problem, grid, *store); }});
        }
    return jobs;
}

/// What the claim rests on, of runs that are not kept.
std::vector<TalliedEstimate> tallied_anew() {
    Series all;
    for (const KnownProblem& problem : known_problems(Fidelity::draft))
        std::ranges::move(series_of(problem), std::back_inserter(all));
    return tally(halves_of(all));
}

constexpr auto held = "truths held by the default, reporting half [%]";
constexpr auto width = "its median half-width [true errors]";
constexpr auto chosen = "chosen by the rule";

reports::Measurement measure(const std::vector<TalliedEstimate>& tallied, std::size_t grids) {
    const auto at = std::ranges::find_if(tallied, [&](const TalliedEstimate& t) {
        return t.name == reports::default_estimate && t.grids == grids;
    });
    return reports::Measurement()
        .value(held, 100.0 * at->reporting.coverage)
        .value(width, at->reporting.median_width)
        .value(chosen, choice(tallied) == reports::default_estimate ? 1.0 : 0.0);
}

std::vector<reports::Study> studies() {
    using namespace term;
    // Made once for both numbers of grids.
    const auto tallied = std::async(std::launch::deferred, tallied_anew).share();
    reports::Study study("coverage");
    study.refines("grids of a set", {3, 4})
        .measure([=](int grids) { return measure(tallied.get(), std::size_t(grids)); })
        .covers({heat_conduction, heat_convection, heat_interface, elasticity, equilibrium,
                 surface_motion, pyrolysis});
    for (const int grids : {3, 4})
        study
            .bound(held, grids, at_least(95.0),
                   "what it is chosen for; a half where it was not chosen may fall short of it")
            .bound(width, grids, at_most(4.0), "an interval that holds all by being wide is none")
            .bound(chosen, grids, at_least(1.0), "the default is what the rule chooses");
    return {study};
}

const Registered here{{.name = "coverage",
                       .figure = "-",
                       .shows = "how often estimates of uncertainty hold the truth",
                       .cost = {.draft = 30.0, .paper = 240.0, .verify = 30.0},
                       .draw = coverage,
                       .jobs = jobs,
                       .studies = studies}};

}  // namespace

}  // namespace crawford
