/// # Sandwich, refined: what converges, and how fast?
///
/// No solution of the burning sandwich is known, so successive refinements are compared: columns,
/// rows and steps, each alone, for the thermo-mechanical sandwich 8 ms after it is lit (it ignites
/// at 3 ms and has burnt 17 um). Orders come from differences between grids, never from the finest
/// taken for the truth.
///
/// Steps: order 1 in every number, as the paper's splitting is: what each module takes from the
/// last step. Anything done once a step without the measure of dt (a filter, a stress given up, a
/// smoothing) would accumulate as 1/dt and end that.
///
/// Rows: order 2 where the surface is smooth, in the outer third of the AP. At the
/// interface the surface burns a notch, where nothing is smooth. (Steps of 80 us on 192 rows would
/// leave 0.1 K of the ringing that Crank-Nicolson answers the sudden flux with.)
///
/// Columns: two things meet where interface and surface do, and neither is smooth.
///
/// - Stress is singular, r^(lambda - 1) with lambda = 0.595. Means over a fixed box beside the
///   corner exist; finite elements give them at order 2 lambda = 1.19, the singularity once in the
///   stress and once in the dual problem. An element that locks does not: q1 shows 0.6, or none.
/// - The surface burns a notch one cell wide at first: AP beside hot binder burns faster than AP
///   alone and leads, and the binder is drawn down after it.
///
/// What is gated of the second is its size, what a user has to reckon with: the change from half
/// the columns of T_s on the axis, of the notch, and of both rates. The mean over the arc changes
/// more than the regression rate, because the binder in the notch is the hottest of the surface and
/// only a cell or two of it is there.

#include <algorithm>
#include <cmath>

#include "cases/registry.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::between;
using reports::expect;
using reports::Measurement;
using reports::Norm;
using reports::Setting;

constexpr double interface = 30.0 * um;
constexpr double middle = 105.0 * um;  // beyond it the notch, of lower order, is not felt
constexpr double box = 15.0 * um;
constexpr double coarsest_column = 7.5 * um;

constexpr auto rate = "mean burn rate [m/s]";
constexpr auto temperature = "T_s, x > 105 um [K]";
constexpr auto surface = "surface, x > 105 um [m]";
constexpr auto notch = "surface at the interface [m]";
constexpr auto axis = "T_s on the axis [K]";
constexpr auto corner_pressure = "p, 15 um of AP beside the corner [Pa]";
constexpr auto corner_stress = "sigma_11, 15 um of AP beside the corner [Pa]";
constexpr auto far_stress = "sigma_11, x > 90 um, 15 um deep [Pa]";
constexpr auto strain = "strain, 15 um of binder beside the corner";

constexpr auto axis_change = "T_s on the axis, change from half the columns [K]";
constexpr auto notch_change = "surface at the interface, change from half the columns [m]";
constexpr auto rate_change = "mean burn rate, change from half the columns, relative";
constexpr auto regression = "regression rate [m/s]";
constexpr auto regression_change = "regression rate, change from half the columns, relative";
constexpr int coarsest = 32;

/// The axes are keys of the scene; where steps are refined, their number until the end.
Scene scene(const Setting& at) {
    Scene result = sandwich({"time.end=8 ms"});
    result.domain.nx = at.count("columns");
    result.domain.ny = at.count("rows");
    result.time.step = at.has("steps") ? 8.0 * ms / at.count("steps") : at.number("step");
    return result;
}

/// Mean of a quantity of cells between two places, down to a depth below the surface [m].
template <class Read>
double mean(const Snapshot& at, double from, double to, double depth, const Read& read) {
    double sum = 0.0;
    double area = 0.0;
    const int top = at.position.rows() - 1;
    for (int i = 0; i + 1 < at.position.columns(); ++i)
        for (int j = 0; j < top; ++j) {
            const auto eta = [&](int row) {
                return at.position(i, row).y() - at.position(i, top).y();
            };
            const double width =
                std::min(to, at.position(i + 1, j).x()) - std::max(from, at.position(i, j).x());
            const double height = eta(j + 1) - std::max(-depth, eta(j));
            if (width <= 0.0 || height <= 0.0) continue;
            sum += width * height * read(i, j);
            area += width * height;
        }
    return sum / area;
}

/// A quantity of surface nodes at the columns of the coarsest grid between two places.
template <class Read>
reports::Sample along_surface(const Snapshot& at, double from, double to, const Read& read) {
    reports::Sample sample;
    const int count = int(std::lround((to - from) / coarsest_column)) + 1;
    for (int k = 0; k < count; ++k) {
        const double x = from + k * coarsest_column;
        const int last = at.position.columns() - 1;
        const double dx = at.position(last, 0).x() / last;
        sample.values.push_back(read(int(std::lround(x / dx)), at.position.rows() - 1));
    }
    return sample;
}

Measurement measure(const Setting& at, double h) {
    const auto burn = kept_burn(scene(at), {});
    const Snapshot& last = burn->last;
    const auto t = [&](int i, int j) { return last.temperature(i, j); };
    const auto y = [&](int i, int j) { return last.position(i, j).y(); };
    const auto p = [&](int i, int j) { return last.pressure(i, j); };
    const auto s11 = [&](int i, int j) { return last.stress(i, j).s11; };
    const auto e = [&](int i, int j) { return last.strain_norm(i, j); };
    const double side = last.position(last.position.columns() - 1, 0).x();
    return Measurement(h)
        .value(rate, burn->mean_burn_rate.back())
        .value(regression, burn->regression_rate.back())
        .sample(temperature, along_surface(last, middle, side, t))
        .sample(surface, along_surface(last, middle, side, y))
        .sample(notch, along_surface(last, interface, interface, y))
        .sample(axis, along_surface(last, 0.0, 0.0, t))
        .value(corner_pressure, mean(last, interface, interface + box, box, p))
        .value(corner_stress, mean(last, interface, interface + box, box, s11))
        .value(far_stress, mean(last, side - interface, side, box, s11))
        .value(strain, mean(last, interface - box, interface, box, e));
}

/// As above, and how far the numbers without an order are from those of half the columns.
Measurement measure_columns(const Setting& at) {
    const int columns = at.count("columns");
    Measurement result = measure(at, 1.0 / columns);
    if (columns == coarsest) return result;
    Setting coarser = at;
    const Measurement half = measure(coarser.set("columns", long(columns / 2)), 2.0 / columns);
    const auto change = [&](const char* quantity) {
        return result.sample_of(quantity)->values.front() -
               half.sample_of(quantity)->values.front();
    };
    return result.value(axis_change, change(axis))
        .value(notch_change, change(notch))
        .value(rate_change, change(rate) / *result.value_of(rate))
        .value(regression_change, change(regression) / *result.value_of(regression));
}

reports::Study in_steps() {
    const auto first = expect(1.0).within(0.05);
    const auto why = "each module takes something from the last step";
    reports::Study study("sandwich-refinement, steps");
    study.at("columns", 32L)
        .at("rows", 48L)
        .refines("steps", {50, 100, 200, 400})
        .any_value()
        .measure([](const Setting& at) { return measure(at, 1.0 / at.count("steps")); })
        .covers({term::time_step, term::heat_storage, term::pyrolysis, term::thermal_stress,
                 term::jaumann_rotation});
    for (const auto quantity : {rate, temperature, surface, notch, axis, corner_pressure,
                                corner_stress, far_stress, strain})
        study.difference_gate(quantity, Norm::L2, first, why);
    return study;
}

reports::Study in_rows() {
    const auto second = expect(2.0).within(0.15);
    reports::Study study("sandwich-refinement, rows");
    study.at("columns", 64L)
        .at("step", reports::Amount{40.0 * us, "s"})
        .refines("rows", {24, 48, 96})
        .any_value()
        .measure([](const Setting& at) { return measure(at, 1.0 / at.count("rows")); })
        .covers({term::clustering, term::heat_conduction, term::thermal_stress})
        .difference_gate(temperature, Norm::L2, second, "bilinear elements, smooth there")
        .difference_gate(surface, Norm::L2, second, "follows T_s")
        .difference_gate(far_stress, Norm::magnitude, second.or_better(0.15),
                         "thermal stress; WENO3's third order fades");
    return study;
}

reports::Study in_columns() {
    const auto singular = expect(1.19).within(0.3).scattering(0.4);
    const auto why = "2 lambda, lambda = 0.595; two pairs of grids scatter about it";
    reports::Study study("sandwich-refinement, columns");
    study.at("rows", 48L)
        .at("step", reports::Amount{80.0 * us, "s"})
        .refines("columns", {32, 64, 128, 256})
        .measure(measure_columns)
        .covers({term::elastic_interface, term::incompressibility, term::heat_interface,
                 term::slope, term::surface_kink, term::jaumann_rotation})
        .difference_gate(corner_pressure, Norm::magnitude, singular, why)
        .difference_gate(corner_stress, Norm::magnitude, singular.or_better(0.3),
                         "as the pressure at the least; faster until the notch is resolved")
        .bound(axis_change, 256, between(-1.0, 1.0),
               "no order yet: 0.6, 0.7, 0.7 K; 0.2 % of the rise")
        .bound(notch_change, 256, between(-0.8 * um, 0.8 * um), "no order yet: less than a cell")
        .bound(rate_change, 256, between(-2e-3, 2e-3), "5.7, 3.6, 1.5 parts in 1000: it halves")
        .bound(regression_change, 256, between(-1e-3, 1e-3), "what a user has to reckon with");
    return study;
}

std::vector<reports::Study> studies() {
    return {in_steps(), in_rows(), in_columns()};
}

const Registered here{{.name = "sandwich-refinement",
                       .figure = "-",
                       .shows = "burning sandwich, refined in columns, rows and steps",
                       .physics = {physics::sandwich},
                       .cost = {.verify = 10.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
