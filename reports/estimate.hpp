/// Estimates of the uncertainty of a value on the finest of several grids, by procedures of the
/// literature.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace crawford::reports {

/// What one procedure says. Numbers that it does not give are NaN, and the note says why.
struct Estimate {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    std::string name = {};
    double order = none;         ///< That the extrapolation uses
    double extrapolated = none;  ///< The limit, h -> 0
    double uncertainty = none;   ///< Half-width about the value on the finest grid, its unit
    double relative_uncertainty = none;  ///< To the size of that value
    double safety = none;                ///< Factor of safety
    std::string note = {};
};

/// `h` falls, one value each, all finite.
struct GridValues {
    std::span<const double> h, values;
};

/// "celik-2008": Celik, Ghia, Roache, Freitas, Coleman and Raad, Procedure for Estimation and
/// Reporting of Uncertainty Due to Discretization in CFD Applications, J. Fluids Eng. 130(7),
/// 078001 (2008): eq. 3 to 7. Three finest grids, any ratios, safety 1.25, order as observed.
Estimate celik_2008(const GridValues& grids);

/// "roache": extrapolate(), Roache's grid convergence index with the order held within [0.5,
/// formal], safety 1.25 where the observed order is within 10 % of formal, else 3.
Estimate roache(const GridValues& grids, double formal_order);

/// "xing-stern-2010": Xing and Stern, Factors of Safety for Richardson Extrapolation, J. Fluids
/// Eng. 132(6), 061403 (2010). With P = observed/formal order: (2.45 - 0.85 P) |delta| up to P = 1,
/// (16.4 P - 14.8) |delta| above. Three finest grids; for values that converge one way.
/// Where the numbers come from: the paper's factors are 2.45 at P = 0 and 1.6 at P = 1, linear
/// between, and 1.6 P + 14.8 (P - 1) above; 1.6, 2.45 and 14.8 also stand, as its Table 1, in the
/// manual of a public calculator of uncertainty. Not held against a printed example.
Estimate xing_stern_2010(const GridValues& grids, double formal_order);

/// "eca-hoekstra-2014": Eca and Hoekstra, A procedure for the estimation of the numerical
/// uncertainty of CFD calculations based on grid refinement studies, J. Comput. Phys. 262, 104
/// (2014). Least squares over all grids, four at least; made for schemes of second order.
/// Where the numbers come from: a public implementation in Python that names the paper has the same
/// weights 1/h, range of the data, limits 0.5 <= p < 2.1 and sigma < range, factors 1.25 and 3, and
/// both formulas of the uncertainty. It differs in two things, where this one goes by the paper as
/// we know it: above p = 2 it keeps the free fit, and its sigma divides by n - 1, not by n less the
/// unknowns. Not held against a printed example.
Estimate eca_hoekstra_2014(const GridValues& grids);

/// All four, in this order.
std::vector<Estimate> estimates(const GridValues& grids, double formal_order);

}  // namespace crawford::reports
