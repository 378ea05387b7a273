#include "reports/estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "reports/extrapolate.hpp"

namespace crawford::reports {
namespace {

constexpr double highest_order = 12.0;  // as extrapolate(): beyond any scheme

/// The three finest grids, numbered as the papers do: 1 is the finest.
struct Three {
    double h1, h2, h3, u1, u2, u3;
};

bool three_finest(const GridValues& grids, Three& three, Estimate& estimate) {
    const auto &h = grids.h, &u = grids.values;
    const std::size_t n = h.size();
    if (n < 3) {
        estimate.note = fmt::format("needs three grids, not {}", n);
        return false;
    }
    three = {h[n - 1], h[n - 2], h[n - 3], u[n - 1], u[n - 2], u[n - 3]};
    if (three.u1 == three.u2 || three.u2 == three.u3) {
        estimate.note = "two of the three finest grids have the same value: no order to read";
        return false;
    }
    return true;
}

void set_uncertainty(Estimate& estimate, double uncertainty, double finest) {
    estimate.uncertainty = uncertainty;
    if (finest != 0.0) estimate.relative_uncertainty = uncertainty / std::abs(finest);
}

/// p = |ln|eps32/eps21| + q(p)| / ln r21 with q = ln((r21^p - s)/(r32^p - s)) (eq. 3).
double order_of_celik(const Three& g) {
    const double log_21 = std::log(g.h2 / g.h1), log_32 = std::log(g.h3 / g.h2);
    const double ratio = (g.u3 - g.u2) / (g.u2 - g.u1);
    const auto q = [&](double p) {
        if (ratio > 0.0) return std::log(std::expm1(p * log_21) / std::expm1(p * log_32));
        return std::log((std::exp(p * log_21) + 1.0) / (std::exp(p * log_32) + 1.0));
    };
    const auto residual = [&](double p) {
        return p * log_21 - std::abs(std::log(std::abs(ratio)) + q(p));
    };
    // Negative at p = 0. Where r32 is above the square of r21 it is negative again for high p, by the
    // absolute value: the first root is the order.
    constexpr double step = 0.05;
    double low_end = 1e-6, high_end = step;
    while (high_end < highest_order && residual(high_end) < 0.0) {
        low_end = high_end;
        high_end += step;
    }
    if (!(residual(low_end) < 0.0 && residual(high_end) >= 0.0)) return Estimate::none;
    std::uintmax_t iterations = 200;
    const auto [low, high] = boost::math::tools::toms748_solve(
        residual, low_end, high_end, boost::math::tools::eps_tolerance<double>(48), iterations);
    return 0.5 * (low + high);
}

double observed(const Three& g) {
    const double h[]{g.h3, g.h2, g.h1}, u[]{g.u3, g.u2, g.u1};
    return observed_order(h, u);
}

}  // namespace

Estimate celik_2008(const GridValues& grids) {
    Estimate estimate{.name = "celik-2008"};
    Three g{};
    if (!three_finest(grids, g, estimate)) return estimate;
    estimate.order = order_of_celik(g);
    if (std::isnan(estimate.order)) {
        estimate.note = "eq. 3 has no order above 0 and below 12";
        return estimate;
    }
    const double gain = std::pow(g.h2 / g.h1, estimate.order) - 1.0;
    estimate.extrapolated = g.u1 + (g.u1 - g.u2) / gain;
    estimate.safety = 1.25;
    set_uncertainty(estimate, estimate.safety * std::abs(g.u1 - g.u2) / gain, g.u1);
    if ((g.u3 - g.u2) * (g.u2 - g.u1) < 0.0)
        estimate.note = "the values swing about their limit";
    else if (observed(g) <= 0.0)
        estimate.note =
            "the values diverge; the procedure takes the absolute value and does not see it";
    return estimate;
}

Estimate roache(const GridValues& grids, double formal_order) {
    Estimate estimate{.name = "roache"};
    Three g{};
    if (!three_finest(grids, g, estimate)) return estimate;
    const auto limit = extrapolate(grids.h, grids.values, formal_order);
    estimate.order = limit.order;
    estimate.extrapolated = limit.value;
    estimate.safety = limit.safety;
    set_uncertainty(estimate, limit.uncertainty, g.u1);
    estimate.note =
        fmt::format("observed order {:.3g}, formal {:.3g}", limit.observed, formal_order);
    return estimate;
}

Estimate xing_stern_2010(const GridValues& grids, double formal_order) {
    Estimate estimate{.name = "xing-stern-2010"};
    Three g{};
    if (!three_finest(grids, g, estimate)) return estimate;
    const double p = observed(g);
    if ((g.u3 - g.u2) * (g.u2 - g.u1) < 0.0 || !(p > 0.0)) {
        estimate.note = "only for values that converge one way";
        return estimate;
    }
    const double share = p / formal_order;
    const double delta = (g.u1 - g.u2) / (std::pow(g.h2 / g.h1, p) - 1.0);
    estimate.order = p;
    estimate.extrapolated = g.u1 + delta;
    estimate.safety = share <= 1.0 ? 2.45 - 0.85 * share : 16.4 * share - 14.8;
    set_uncertainty(estimate, estimate.safety * std::abs(delta), g.u1);
    estimate.note = fmt::format("P = {:.3g}, observed to formal order", share);
    return estimate;
}

std::vector<Estimate> estimates(const GridValues& grids, double formal_order) {
    return {celik_2008(grids), roache(grids, formal_order), xing_stern_2010(grids, formal_order),
            eca_hoekstra_2014(grids)};
}

}  // namespace crawford::reports
