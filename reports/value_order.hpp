/// Observed order of values whose limit is not known, on three grids and more of any refinement
/// ratios.
#pragma once

#include <vector>

#include "reports/gate.hpp"

namespace crawford::reports {

/// The value of one grid.
struct ValueLevel {
    int grid;      ///< Cells along the side that is refined, or the number of the grid
    double h;      ///< Cell size, any unit
    double value;  ///< NaN where the run failed
};

/// Values of one quantity over several grids. They converge as u = u0 + C h^p, so neighbouring
/// grids differ by C (h_i^p - h_i+1^p).
class ValueConvergence {
public:
    /// Levels are sorted by falling h.
    explicit ValueConvergence(std::vector<ValueLevel> levels);

    const std::vector<ValueLevel>& levels() const { return levels_; }
    std::vector<double> h() const;
    std::vector<double> values() const;

    /// Observed order of each three neighbouring grids: two fewer than the levels.
    std::vector<double> pairwise() const;

    /// The p that makes log|u_i - u_i+1| and log(h_i^p - h_i+1^p) differ least, in least squares,
    /// by a constant. With one refinement ratio it is the slope of log|u_i - u_i+1| against log h.
    /// NaN below three levels or where two values are the same.
    double fit() const;

    /// \see Verdict. Values that swing about their limit oscillate. Meaningful only where defect()
    /// is empty.
    Verdict verdict(double scatter = default_scatter) const;

    /// Why no order may be read, if so: too few grids, a NaN, a cell size that is not positive or
    /// stands twice, neighbouring values that are the same to round-off.
    std::optional<std::string> defect() const;

private:
    std::vector<double> differences() const;

    std::vector<ValueLevel> levels_;  // coarsest first
};

/// Holds values against a gate, as judge() does errors: all levels within the range of the gate.
GateResult judge(const Gate& gate, const ValueConvergence& convergence);

}  // namespace crawford::reports
