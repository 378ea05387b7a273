/// Known values as records: a run on a grid is made once.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "cases/explore/coverage/known_problem.hpp"
#include "reports/interval_coverage.hpp"
#include "reports/record_store.hpp"

namespace crawford {

/// Kept in out/records by the sources they are made of.
std::shared_ptr<reports::RecordStore> records_of_values(const std::filesystem::path& out);

/// Makes the record of a problem on a grid where there is none.
void keep_values(const KnownProblem& problem, int grid, reports::RecordStore& store);

/// The quantities of a problem over its grids.
/// \throws NumericalFailure naming problem and grid, if a run has failed.
std::vector<reports::KnownSeries> series_of(const KnownProblem& problem,
                                            reports::RecordStore& store);

/// The same of runs that are made now and not kept.
std::vector<reports::KnownSeries> series_of(const KnownProblem& problem);

}  // namespace crawford
