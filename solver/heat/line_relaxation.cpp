#include "solver/heat/line_relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"

namespace crawford {

namespace {

// Some 20 sweeps for each unit of D dt/dx^2: enough for steps a hundred times those of the paper,
// or for 512 columns.
constexpr int most_sweeps = 2000;

// Of what a step changes, the part that may be wrong: small beside the error of the step itself.
constexpr double share_of_step = 1e-3;

/// The Thomas algorithm on every column. What it makes of the coefficients is kept from sweep to
/// sweep.
class ColumnSolver {
public:
    ColumnSolver(const NodeStencil& a, const NodeField& x)
        : a_(a), factors_(x.columns(), x.rows()), value_(size_t(x.rows())) {
        for (int i = 0; i < x.columns(); ++i)
            for (int j = 1; j < x.rows(); ++j) {
                const auto& c = a.row(i, j)[1];
                const double pivot = c[1] - c[0] * factors_(i, j - 1).upper;
                factors_(i, j) = {c[0] / pivot, 1.0 / pivot, c[2] / pivot};
            }
    }

    /// \returns the largest change in the column.
    double solve(const NodeField& b, NodeField& x, int i) {
        const int rows = x.rows();
        value_[0] = x(i, 0);
        for (int j = 1; j < rows; ++j) {
            const double rhs = b(i, j) - a_.column_sum(x, i, j, -1) - a_.column_sum(x, i, j, 1);
            const Factors& f = factors_(i, j);
            value_[size_t(j)] = f.inverse * rhs - f.lower * value_[size_t(j) - 1];
        }
        double change = 0.0;
        double above = 0.0;
        for (int j = rows - 1; j > 0; --j) {
            const double value = value_[size_t(j)] - factors_(i, j).upper * above;
            const double step = std::abs(value - x(i, j));
            if (!(step <= change)) change = step;  // also true for a NaN
            x(i, j) = above = value;
        }
        return change;
    }

private:
    struct Factors {
        double lower = 0.0, inverse = 0.0, upper = 0.0;  ///< over the pivot
    };

    const NodeStencil& a_;
    Lattice<Factors> factors_;
    std::vector<double> value_;
};

/// How far the answer still is, from how the changes of the sweeps shrink. Sweeps there and back
/// change unlike much: what counts is what a pair of them leaves.
class Distance {
public:
    void sweep(double change) {
        if (sweeps_ == 0) first_ = change;
        before_ = last_;
        last_ = now_;
        now_ = change;
        ++sweeps_;
    }
    /// What a sweep leaves of the distance; zero as long as there is no pair to tell it.
    double contraction() const {
        return sweeps_ > 2 && before_ > 0.0 ? std::sqrt(now_ / before_) : 0.0;
    }
    bool within(double tolerance) const {
        const double rho = contraction();
        if (sweeps_ <= 2 || rho >= 1.0) return false;
        // The step moves some value by first/(1 - rho), the distance left is change rho/(1 - rho).
        const double change = std::max(now_, last_);
        return now_ <= tolerance && change * rho <= (1.0 - rho) * tolerance &&
               change * rho <= share_of_step * first_;
    }

private:
    int sweeps_ = 0;
    double first_ = 0.0;
    double before_ = 0.0, last_ = 0.0, now_ = 0.0;  ///< changes of the last three sweeps
};

double round_off(const NodeField& x) {
    double largest = 0.0;
    for (const double value : x.values()) largest = std::max(largest, std::abs(value));
    return 4.0 * std::numeric_limits<double>::epsilon() * largest;
}

}  // namespace

Relaxation relax_columns(const NodeStencil& a, const NodeField& b, NodeField& x, double tolerance) {
    ColumnSolver column(a, x);
    const int columns = x.columns();
    Distance distance;
    const double least_change = round_off(x);
    double largest = 0.0;
    int worst = 0;
    for (int sweep = 1; sweep <= most_sweeps; ++sweep) {
        largest = 0.0;
        for (int k = 0; k < columns; ++k) {
            const int i = sweep % 2 == 1 ? k : columns - 1 - k;
            const double change = column.solve(b, x, i);
            if (!(change <= largest)) {
                largest = change;
                worst = i;
            }
        }
        if (columns == 1 && std::isfinite(largest)) return {sweep, 0.0};
        if (std::isnan(largest)) break;
        distance.sweep(largest);
        if (largest <= least_change || distance.within(tolerance))
            return {sweep, distance.contraction()};
    }
    throw NumericalFailure(
        {.kind = FailureFields::Kind::no_convergence,
         .module = "heat",
         .quantity = fmt::format("change of the line relaxation, {} sweeps allowed,", most_sweeps),
         .value = largest,
         .unit = "K",
         .limit = FailureLimit{.value = tolerance},
         .place = FailurePlace{"node column", worst},
         .advice = "reduce time.step"});
}

}  // namespace crawford
