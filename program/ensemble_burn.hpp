/// From burns as they lie in their folders to what an ensemble is made of.
#pragma once

#include <optional>

#include "program/found_runs.hpp"
#include "reports/ensemble.hpp"

namespace crawford {

/// \param after time from which on a burn counts [s]; half its end where none is given
/// \throws InputError if the history of a burn that is done cannot be read, or ends before that.
reports::EnsembleBurn ensemble_burn(const FoundRun& run, const std::optional<double>& after);

}  // namespace crawford
