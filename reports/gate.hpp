/// Gates: one written line each that says what a study must reach and why, and the judgement on it.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "reports/extrapolate.hpp"
#include "reports/norm.hpp"
#include "reports/order.hpp"

namespace crawford::reports {

/// Order expected of an error, and how far the fit may miss it. Reads as
/// expect(2.0).within(0.1).from(64).to(256).
struct Expectation {
    double order;                      ///< Formal order
    double below = 0.0;                ///< How far the fit may fall short
    double above = 0.0;                ///< How far it may exceed
    double scatter = default_scatter;  ///< How far a pairwise order may lie from the fit
    std::optional<int> coarsest,
        finest;                   ///< Grids that the fit runs over; all of the run if not said
    std::optional<double> scale;  ///< Size of the truth, where the measurement does not know it

    Expectation within(double both) const { return within(both, both); }
    Expectation within(double less, double more) const;
    /// No upper limit: a scheme may do better than proven.
    Expectation or_better(double less) const;
    Expectation from(int coarsest_grid) const;
    Expectation to(int finest_grid) const;
    Expectation scattering(double limit) const;
    Expectation of_size(double truth) const;
};
Expectation expect(double order);

/// Closed interval that a number must lie in.
struct Interval {
    double low, high;
};
Interval between(double low, double high);
Interval at_most(double high);  ///< From -infinity
Interval at_least(double low);  ///< To +infinity

/// One row of a study's order table.
struct Gate {
    std::string quantity;
    Norm norm;
    Expectation expected;
    std::string reason;  ///< Why this order and this tolerance: printed beside the judgement
};

/// One number held against an interval.
struct Bound {
    std::string quantity;  ///< With its unit
    Interval allowed;
    std::string reason;
};

enum class GateKind { order, bound };

constexpr double not_applicable = std::numeric_limits<double>::quiet_NaN();

/// The judgement on one gate with all the numbers it rests on. Numbers that do not apply are NaN
/// (null in JSON).
struct GateResult {
    GateKind kind = GateKind::order;
    std::string study, quantity, norm, reason;

    std::vector<int> grids;  ///< All grids measured, coarsest first
    std::vector<double> h,
        errors;  ///< One per grid (or per pair of grids, where the errors are differences)
    std::vector<double> pairwise;  ///< One fewer
    std::vector<double> values;    ///< Bounds: the value on each grid, instead of errors
    double scale = 1.0;            ///< Size of the truth in the norm
    int coarsest = 0, finest = 0;  ///< Range of the fit
    double fit = not_applicable, expected = not_applicable, below = not_applicable,
           above = not_applicable;
    Extrapolation limit{not_applicable, not_applicable, not_applicable, not_applicable,
                        not_applicable};
    std::string verdict;

    double value = not_applicable, low = not_applicable, high = not_applicable;  ///< Bounds only

    bool passed = false;
    bool gated = true;    ///< False: grids were left out on purpose, so it neither passes nor fails
    std::string failure;  ///< Why it has not passed; empty if it has
    double seconds = 0.0;  ///< Wall time of the runs behind it

    bool fell_short() const { return gated && !passed; }
};

/// Holds a convergence against a gate. `wanted` are the grids that were asked for: one without an
/// error is a failure. Passes only if no defect, verdict monotone, fit within tolerance.
/// `left_out` are grids of the gate that were not asked for: if there are any it is not gated, but
/// what has gone wrong on the others (no error, NaN) still makes it fail.
GateResult judge(const Gate& gate, const Convergence& convergence, const std::vector<int>& wanted,
                 const std::vector<int>& left_out = {});

/// Why a fit and its verdict fall short of what is expected; empty if they do not.
std::string short_of(const Expectation& expected, Verdict verdict, double fit);

/// Holds a number against a bound; NaN fails.
GateResult judge(const Bound& bound, double value);

/// Takes the judgement back, because the grids `left_out` were not asked for.
void leave_ungated(GateResult& result, const std::vector<int>& left_out);

}  // namespace crawford::reports
