#include "cases/explore/coverage/known_records.hpp"

#include <fmt/format.h>

#include "base/build_info.hpp"
#include "base/errors.hpp"

namespace crawford {

namespace {

constexpr auto experiment = "coverage, values";

std::string truth_of(const std::string& quantity) {
    return quantity + ", exact";
}

reports::Record record_of(const KnownProblem& problem, int grid, reports::RecordStore& store) {
    const auto setting = reports::Setting().set("problem", problem.name).set("grid", long(grid));
    if (auto kept = store.find(experiment, setting)) return *kept;
    reports::Record made = reports::record_of(experiment, setting, [&](reports::Record& record) {
        record.found = reports::Measurement(1.0 / grid);
        for (const KnownValue& known : problem.measure(grid))
            record.found->value(known.name, known.value).value(truth_of(known.name), known.truth);
    });
    store.add(made);
    return made;
}

/// Each value is followed by its truth.
std::vector<KnownValue> known_values(const reports::Measurement& found) {
    std::vector<KnownValue> values;
    for (std::size_t k = 0; k + 1 < found.values().size(); k += 2)
        values.push_back({found.values()[k].first, found.values()[k].second.value,
                          found.values()[k + 1].second.value});
    return values;
}

/// The next grid of all quantities of a problem, which come in one order on all.
void add(std::vector<reports::KnownSeries>& all, const KnownProblem& problem, int grid,
         const std::vector<KnownValue>& values) {
    if (all.empty())
        for (const KnownValue& known : values)
            all.push_back({.problem = problem.name,
                           .name = problem.name + ": " + known.name,
                           .order = problem.order,
                           .truth = known.truth});
    for (std::size_t k = 0; k < values.size(); ++k) {
        all[k].h.push_back(1.0 / grid);
        all[k].values.push_back(values[k].value);
    }
}

}  // namespace

std::shared_ptr<reports::RecordStore> records_of_values(const std::filesystem::path& out) {
    return std::make_shared<reports::RecordStore>(out / "records", source_fingerprint());
}

void keep_values(const KnownProblem& problem, int grid, reports::RecordStore& store) {
    record_of(problem, grid, store);
}

std::vector<reports::KnownSeries> series_of(const KnownProblem& problem,
                                            reports::RecordStore& store) {
    std::vector<reports::KnownSeries> all;
    for (const int grid : problem.grids) {
        const reports::Record record = record_of(problem, grid, store);
        if (!record.ending.is_done())
            throw NumericalFailure(fmt::format("coverage, {}, grid {}: {}", problem.name, grid,
                                               record.ending.message));
        add(all, problem, grid, known_values(*record.found));
    }
    return all;
}

std::vector<reports::KnownSeries> series_of(const KnownProblem& problem) {
    std::vector<reports::KnownSeries> all;
    for (const int grid : problem.grids) add(all, problem, grid, problem.measure(grid));
    return all;
}

}  // namespace crawford
