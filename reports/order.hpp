/// Observed orders of accuracy: how fast an error falls as the grid is refined, and whether the
/// fall can be trusted.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace crawford::reports {

/// What a sequence of errors looks like.
enum class Verdict {
    monotone,        ///< Falls at every refinement, at one rate: an order may be read
    oscillating,     ///< Falls on the whole, rises in between
    diverging,       ///< Does not fall
    not_asymptotic,  ///< Falls, but at a rate that still changes from grid to grid
};

/// "monotone", "oscillating", "diverging", "not asymptotic".
std::string_view name(Verdict verdict);

/// The error of one grid.
struct Level {
    int grid;      ///< Cells along the side that is refined
    double h;      ///< Cell size that the order is read against, any unit
    double error;  ///< >= 0, or NaN where the run failed
};

/// An error below this many times the size of the truth is taken for round-off.
inline constexpr double roundoff = 1e-12;

/// How far a pairwise order may lie from the fit before the sequence counts as not asymptotic,
/// unless a gate says otherwise. A next term of one order more, C h^p (1 + a h), then moves the fit
/// over four halved grids by at most 0.27 (pairwise excesses d, d/2, d/4; the fit weighs them
/// 3:4:3), so the tolerance of a gate stays the sharper test.
inline constexpr double default_scatter = 0.2;

/// p of y ~ x^p: slope of the least-squares line of log(y) against log(x); NaN below two points.
double slope_of_logarithms(std::span<const double> x, std::span<const double> y);

/// Errors of one quantity in one norm over several grids, coarsest first.
class Convergence {
public:
    /// `scale` is the size of the truth in the same norm and unit (1 if errors are relative): it
    /// tells a small error from round-off. `least` is the number of levels below which no order is
    /// read. Levels are sorted by falling h.
    explicit Convergence(std::vector<Level> levels, double scale = 1.0, std::size_t least = 3);

    const std::vector<Level>& levels() const { return levels_; }
    double scale() const { return scale_; }

    /// Only the grids from `coarsest` to `finest`, both included.
    Convergence between(int coarsest, int finest) const;

    /// log(e_i/e_i+1)/log(h_i/h_i+1) for each pair of neighbouring grids: one fewer than the
    /// levels.
    std::vector<double> pairwise() const;

    /// \see slope_of_logarithms, of the errors against h.
    double fit() const;

    /// \see Verdict. Meaningful only where defect() is empty.
    Verdict verdict(double scatter = default_scatter) const;

    /// Why no order may be read from these errors, if so: too few grids, a NaN, a cell size that is
    /// not positive or stands twice, the same error on every grid, an error at round-off.
    std::optional<std::string> defect() const;

private:
    std::vector<Level> levels_;  // coarsest first
    double scale_;
    std::size_t least_;
};

/// Convergence of a solution without a truth, from d_i = |u_i - u_i+1| between neighbouring grids
/// (three grids give two differences and one order). `levels` holds d_i with grid and h of the
/// coarser of the two. The differences fall as h^p only if all grids are refined by one and the
/// same ratio.
/// \throws std::invalid_argument if they are not (to 1 %).
Convergence from_differences(std::vector<Level> levels, double scale = 1.0);

/// Order that reads from the last pair of errors when the finest grid, refined by two, is itself
/// taken for the truth and the true order is p: log2(2^p + 1), always too high (0.38 reads as
/// about 1.2, 1 as 1.58, 2 as 2.32).
double self_referenced_order(double p);

}  // namespace crawford::reports
