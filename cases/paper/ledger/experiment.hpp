/// Runs that the ledger rests on besides those that figures show.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/registry.hpp"
#include "reports/record.hpp"

namespace crawford::ledger {

/// One run: by what its record is known, what is burnt for it, and what it finds.
struct Run {
    std::string experiment;
    reports::Setting setting;
    std::vector<Scene> scenes;  ///< those whose burns `measure` will ask for
    /// \throws NumericalFailure if one of them fails.
    std::function<reports::Measurement(const Request&)> measure;
};

/// The record of a run, done or failed.
/// \throws std::logic_error if there is none.
using Records = std::function<reports::Record(const Run&)>;

/// What a run has found.
/// \throws NumericalFailure if it failed.
reports::Measurement found(const reports::Record& record);

/// \throws std::logic_error naming the experiment if the run has not found the quantity.
double value(const reports::Measurement& found, const std::string& quantity);

}  // namespace crawford::ledger
