/// How often the interval of an estimate holds the truth, and how wide it is, over many quantities
/// whose truth is known.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "reports/estimate.hpp"

namespace crawford::reports {

/// One quantity on a series of grids, coarse to fine.
struct KnownSeries {
    std::string problem = {};  ///< those of one problem come from the same runs, and go together
    std::string name = {};
    double order = 2.0;  ///< formal
    std::vector<double> h = {}, values = {};
    double truth = 0.0;
};

/// Why nothing can be estimated from it, if so: on some grid it is off by no more than round-off, or
/// is no number.
std::string left_out(const KnownSeries& series);

using Estimator = std::function<Estimate(const GridValues& grids, double formal_order)>;

/// From a number to a number, both included.
struct Range {
    double low = Estimate::none, high = Estimate::none;
};

/// What the three finest grids of a set look like.
enum class SetShape {
    regular,      ///< one way, and the observed order within 10 % of the formal one
    irregular,    ///< one way, at another order
    oscillating,  ///< the two differences have opposite signs
    diverging     ///< the finer difference is the larger, or there is no order to read
};
constexpr SetShape set_shapes[]{SetShape::regular, SetShape::irregular, SetShape::oscillating,
                                SetShape::diverging};
std::string name(SetShape shape);

struct ShapeTally {
    std::size_t sets = 0, answered = 0, held = 0;
};

/// One estimate over all sets of so many grids of some quantities. An estimate that says nothing of
/// a set does not hold it.
struct CoverageTally {
    std::size_t problems = 0, quantities = 0, sets = 0, answered = 0, held = 0;
    /// Mean over the quantities of the share of their sets that are held: each counts alike.
    double coverage = Estimate::none;
    /// 95 % of the resamplings of whole problems: sets of a quantity are not independent, nor are
    /// quantities of a problem.
    Range resampled = {};
    /// One set a quantity, that of its finest grids.
    std::size_t finest_held = 0;
    Range binomial = {};  ///< Clopper-Pearson, 95 %, of these
    /// Of the sets that are answered: half-width over the true error of the finest grid.
    double median_width = Estimate::none;
    double upper_width = Estimate::none;      ///< that of nine in ten is below
    double median_relative = Estimate::none;  ///< half-width over the size of the value
    std::map<SetShape, ShapeTally> shapes = {};
};

/// All sets of `size` grids of every series, in the order of their grids.
/// \throws std::invalid_argument if there is no such set.
CoverageTally coverage_of(const Estimator& estimator, const std::vector<KnownSeries>& all,
                          std::size_t size);

/// The factors by which the interval of each set would have to be widened to just hold the truth:
/// |finest - truth| over the half-width, infinite where nothing is said. With the weight of its set:
/// those of a quantity add up to one.
struct WeightedFactor {
    double factor, weight;
};
std::vector<WeightedFactor> factors_of(const Estimator& estimator,
                                       const std::vector<KnownSeries>& all, std::size_t size);

/// Clopper-Pearson's interval of a share, `held` of `of`, 95 %.
Range binomial_interval(std::size_t held, std::size_t of);

}  // namespace crawford::reports
