/// What the trials have cost, and how far off they are.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cases/explore/tradeoff/trial.hpp"

namespace crawford::tradeoff {

/// A trial and its errors: relative ones, of the surface's profile the root of the mean square [um].
struct Point {
    Trial trial;
    reports::Record record;
    std::map<std::string, double> errors;  ///< by quantity; empty if it has not ended well
};

/// What the points of a subject are held against: values by quantity, and the surface.
struct Truth {
    std::string source;                         ///< in words
    std::map<std::string, double> values;       ///< by quantity
    std::map<std::string, double> uncertainty;  ///< of each, as errors are counted
    std::vector<double> profile;                ///< as a trial samples it; may be empty
};

/// From theory where there is one, else from the trial beyond all others, with what its check
/// differs by for its uncertainty.
/// \throws NumericalFailure if that trial failed.
Truth truth_of(const Subject& subject, const std::vector<Point>& points);

/// Errors of a trial that has ended well.
std::map<std::string, double> errors_of(const reports::Measurement& found, const Truth& truth);

}  // namespace crawford::tradeoff
