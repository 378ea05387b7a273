#include "reference/steady_front.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/errors.hpp"
#include "reference/root.hpp"

namespace crawford::reference {
namespace {

double burn_rate(const Material& material, double temperature) {
    return material.pyrolysis_prefactor * std::exp(-material.activation_temperature / temperature);
}

/// r_b [m/s] of the outer material alone: rho r_b (c_p (T_s - T0) - q_s) = Q.
double outer_rate_alone(const Material& material, double flux, double cold) {
    const auto excess_heat = [&](double surface) {
        return material.density * burn_rate(material, surface) *
                   (material.specific_heat * (surface - cold) - material.heat_of_reaction) -
               flux;
    };
    if (excess_heat(cold) >= 0.0) {
        throw std::invalid_argument(fmt::format(
            "outer_flux = {:.3g} W/m^2 is too weak to burn the outer material from {} K", flux,
            cold));
    }
    double hot = 2.0 * cold;
    while (excess_heat(hot) < 0.0) hot *= 2.0;
    return burn_rate(material, bracketed_root(excess_heat, cold, hot));
}

NumericalFailure failure(FailureFields::Kind kind, const std::string& quantity, double value,
                         const std::string& unit, const std::string& advice) {
    return NumericalFailure(FailureFields{.kind = kind,
                                          .module = "steady front of a sandwich",
                                          .quantity = quantity,
                                          .value = value,
                                          .unit = unit,
                                          .advice = advice});
}

class Newton {
public:
    Newton(const SandwichGeometry& geometry, const SandwichFlame& flame, const SlopedHeat& heat)
        : geometry_(geometry), flame_(flame), heat_(heat), level_(heat.interface_column() + 1) {}

    SteadyFront solve();

private:
    struct Trial {
        Eigen::VectorXd slope;
        double rate;
        SlopedHeat::Response response;
        Eigen::VectorXd misfit;  // T_s less what keeps pace [K]
    };

    /// Slope of the strip at the interface, where it is as hot as the outer material has to be.
    struct Steepest {
        double slope;
        double by_log_rate;  // its derivative by log V
    };

    /// Temperature that keeps pace, with derivatives by slope and log V.
    struct Pace {
        double temperature, by_slope, by_log_rate;
    };

    const Material& material(Eigen::Index place) const {
        return place < level_ ? geometry_.inner : geometry_.outer;
    }
    Eigen::Index column(Eigen::Index place) const { return place < level_ ? place : place - 1; }

    Steepest steepest(double rate) const;
    Pace pace(Eigen::Index place, double slope, double rate) const;
    Trial trial(Eigen::VectorXd slope, double rate) const;
    Trial start() const;
    Eigen::MatrixXd jacobian(const Trial& at) const;
    Trial improved(const Trial& from) const;
    void require_rising(const Trial& found) const;

    const SandwichGeometry& geometry_;
    const SandwichFlame& flame_;
    const SlopedHeat& heat_;
    Eigen::Index level_;  // place of the outer material at the interface
};

Newton::Steepest Newton::steepest(double rate) const {
    const double surface = pace_temperature(geometry_.outer, 0.0, rate);
    const double ratio = rate / burn_rate(geometry_.inner, surface);
    if (!(ratio > 1.0)) return {0.0, 0.0};
    const double slope = -std::sqrt((ratio - 1.0) * (ratio + 1.0));
    const double growth =  // of log(ratio) with log V
        1.0 - geometry_.inner.activation_temperature / geometry_.outer.activation_temperature;
    return {slope, ratio * ratio * growth / slope};
}

/// The steeper, the colder, where the surface rises from the interface; continued as an odd function
/// to where it falls, so that Newton's method finds no front that does.
Newton::Pace Newton::pace(Eigen::Index place, double slope, double rate) const {
    const Material& here = material(place);
    const auto by_log_rate = [&](double temperature) {
        return temperature * temperature / here.activation_temperature;
    };
    const double level = pace_temperature(here, 0.0, rate);
    const double sloped = pace_temperature(here, slope, rate);
    const double away = place < level_ ? -1.0 : 1.0;  // from the interface
    const double steepening = -away * by_log_rate(sloped) * std::abs(slope) / (1.0 + slope * slope);
    if (away * slope >= 0.0) return {sloped, steepening, by_log_rate(sloped)};
    return {2.0 * level - sloped, steepening, 2.0 * by_log_rate(level) - by_log_rate(sloped)};
}

Newton::Trial Newton::trial(Eigen::VectorXd slope, double rate) const {
    slope[level_] = 0.0;
    slope[level_ - 1] = steepest(rate).slope;
    Trial made{slope, rate, heat_.respond(slope, rate), Eigen::VectorXd(slope.size())};
    for (Eigen::Index j = 0; j < slope.size(); ++j)
        made.misfit[j] = made.response.surface[column(j)] - pace(j, slope[j], rate).temperature;
    made.misfit[level_ - 1] = 0.0;  // that of the level place once more
    return made;
}

/// The outer material's own speed; a strip as hot as the interface there, and less steep as the
/// surface warms away from it, at the gradient that the flux needs.
Newton::Trial Newton::start() const {
    const Material& inner = geometry_.inner;
    const double rate =
        outer_rate_alone(geometry_.outer, flame_.outer_flux, flame_.cold_temperature);
    const double surface = pace_temperature(geometry_.outer, 0.0, rate);
    const double strip_rate = burn_rate(inner, surface);
    if (strip_rate > (1.0 + 1e-9) * rate) {
        throw std::invalid_argument(fmt::format(
            "the outer material must burn at least as fast as the strip: at {:.0f} K, its surface "
            "alone, they burn at {:.3g} and {:.3g} m/s",
            surface, rate, strip_rate));
    }
    const double gradient = (flame_.inner_flux + inner.heat_of_reaction * inner.density * rate) /
                            inner.thermal_conductivity;
    const double decay =
        inner.activation_temperature / (surface * surface) * std::max(gradient, 0.0);
    const Eigen::VectorXd x = heat_.surface_places();
    Eigen::VectorXd slope(heat_.slopes());
    const double steep = steepest(rate).slope;
    for (Eigen::Index j = 0; j < slope.size(); ++j) {
        const double away = x[column(j)] - geometry_.strip;
        slope[j] = j < level_ ? steep * std::exp(decay * away) : -0.04 * steep;
    }
    return trial(slope, rate);
}

/// d(misfit)/d(slope), and d(misfit)/d(log V) in the column of the level place. The strip's slope
/// at the interface follows V.
Eigen::MatrixXd Newton::jacobian(const Trial& at) const {
    Eigen::MatrixXd derivative(at.slope.size(), at.slope.size());
    for (Eigen::Index j = 0; j < at.slope.size(); ++j) {
        const Pace here = pace(j, at.slope[j], at.rate);
        derivative.row(j) = at.response.by_slope.row(column(j));
        derivative(j, j) -= here.by_slope;
        derivative(j, level_) =
            at.rate * at.response.by_rate[column(j)] - here.by_log_rate +
            at.response.by_slope(column(j), level_ - 1) * steepest(at.rate).by_log_rate;
    }
    derivative.row(level_ - 1).setZero();
    derivative(level_ - 1, level_ - 1) = 1.0;
    return derivative;
}

/// One step, each slope and log V moved no further than they keep their meaning, halved until it
/// makes the misfit smaller.
Newton::Trial Newton::improved(const Trial& from) const {
    constexpr double furthest = 0.5;
    constexpr int halvings = 8;
    const Eigen::VectorXd whole = jacobian(from).partialPivLu().solve(-from.misfit);
    const Eigen::VectorXd step = whole.cwiseMax(-furthest).cwiseMin(furthest);
    for (int k = 0; k <= halvings; ++k) {
        const double share = std::ldexp(1.0, -k);
        Trial made = trial(from.slope + share * step, from.rate * std::exp(share * step[level_]));
        if (made.misfit.norm() < from.misfit.norm()) return made;
    }
    throw failure(FailureFields::Kind::no_convergence, "largest misfit of surface temperature",
                  from.misfit.cwiseAbs().maxCoeff(), "K",
                  "the strip may lead somewhere, which this solution does not know");
}

void Newton::require_rising(const Trial& found) const {
    constexpr double discretisation = 0.1;  // slopes of a coarse mesh scatter about level ones
    const double falls = std::max(found.slope.head(level_).maxCoeff(),
                                  -found.slope.tail(found.slope.size() - level_).minCoeff());
    if (falls > discretisation) {
        throw failure(FailureFields::Kind::beyond_limit, "slope that falls from the interface",
                      falls, "", "the interface does not lead");
    }
}

SteadyFront Newton::solve() {
    constexpr int most = 40;
    constexpr double tolerance = 1e-5;  // [K]: 1e-7 of V; round-off in the finest cells is below it
    Trial at = start();
    for (int k = 0; at.misfit.cwiseAbs().maxCoeff() > tolerance; ++k) {
        if (k == most) {
            throw failure(FailureFields::Kind::no_convergence,
                          "largest misfit of surface temperature", at.misfit.cwiseAbs().maxCoeff(),
                          "K", "");
        }
        at = improved(at);
    }
    require_rising(at);
    return {at.slope, at.rate, at.response.temperature};
}

}  // namespace

double pace_temperature(const Material& material, double slope, double rate) {
    return material.activation_temperature /
           std::log(material.pyrolysis_prefactor * std::hypot(1.0, slope) / rate);
}

SteadyFront find_steady_front(const SandwichGeometry& geometry, const SandwichFlame& flame,
                              const SlopedHeat& heat) {
    return Newton(geometry, flame, heat).solve();
}

}  // namespace crawford::reference
