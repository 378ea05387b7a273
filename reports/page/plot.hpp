/// Plots of gates on a page, as SVG.
#pragma once

#include "reports/gate.hpp"
#include "reports/page/html.hpp"

namespace crawford::reports::page {

/// Error against cell size on logarithmic axes, with the expected slope through the finest grid of
/// the fit; grids outside the fit are hollow. Empty if there is nothing to draw. Colours come from
/// the style of the page, so that it reads in light, in dark and on paper.
Html order_plot(const GateResult& gate);

/// The value of a bound on its number line, with the allowed interval; empty if the value is no
/// number.
Html bound_plot(const GateResult& gate);

}  // namespace crawford::reports::page
