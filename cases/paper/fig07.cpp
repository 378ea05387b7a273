/// # Figure 7: temperature, pressure and strain in a burning sandwich
///
/// A strip of binder, 60 um wide, between blocks of AP burns under 2 MPa; heat flows from the flame
/// at 200 cal/(s cm2) into AP and 160 into the binder. The sandwich is symmetric: the right half is
/// computed and mirrored, and it stands where it has burnt to, with its surface as it is.
///
/// What to trust: temperature, burn rate, and the strain away from the two corners where the
/// interface meets the surface. Stress is singular there, so peak strain and peak pressure grow
/// with every refinement and are given with their grid only; the mean over 5 um about the peak is
/// the number to compare.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "base/build_info.hpp"
#include "cases/columns.hpp"
#include "cases/paper/ledger/evidence.hpp"
#include "cases/paper/ledger/readings.hpp"
#include "cases/registry.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/scenes/sandwich_measures.hpp"
#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;

constexpr double shown_below_surface = 240 * um;
constexpr double above_surface = 8 * um;
constexpr double map_width = 340.0;  // [points]
constexpr double left = 80.0, right = 110.0, foot = 90.0, head = 45.0;

/// What the claims ask for, besides measures.
namespace finds {
constexpr auto deviator_of_AP = "deviatoric stress in AP, root mean square";
constexpr auto deviator_of_binder = "deviatoric stress in binder, root mean square";
}  // namespace finds

/// Root mean square of the deviator over the cells of one material.
double deviator(const Snapshot& snapshot, bool first) {
    double squares = 0.0, cells = 0.0;
    for (size_t k = 0; k < snapshot.stress.values().size(); ++k) {
        const double fraction = snapshot.material.values()[k];
        if (first ? fraction < 0.99 : fraction > 0.01) continue;
        const PlaneStress& s = snapshot.stress.values()[k];
        const double p = (s.s11 + s.s22 + s.s33) / 3.0;
        squares += std::pow(s.s11 - p, 2) + std::pow(s.s22 - p, 2) + std::pow(s.s33 - p, 2) +
                   2.0 * s.s12 * s.s12;
        cells += 1.0;
    }
    return std::sqrt(squares / cells);
}

Outcome fig07(const Request& request) {
    const Scene scene = burning_sandwich(request.fidelity, true);
    const auto burn = kept_burn(scene, request);
    const Snapshot& last = burn->last;
    const Peak strain = peak(last, last.strain_norm, 5.0 * um);
    const Peak pressure = peak(last, last.pressure, 5.0 * um);

    const auto pressures = std::ranges::minmax(last.pressure.values());
    const SurfaceLine surface = surface_line(last);
    const double top = std::ranges::max(surface.height) + above_surface;
    const double bottom = std::ranges::min(surface.height) - shown_below_surface;
    const double map_height = map_width * (top - bottom) / scene.domain.width;
    const double width = left + map_width + right, height = head + map_height + foot;

    reports::Figure figure("fig07", request.out);
    figure.map("T", whole_map(last, "T", "K", last.temperature, 1.0))
        .map("p", whole_map(last, "p", "MPa", last.pressure, MPa))
        .map("strain", whole_map(last, "strain norm", "-", last.strain_norm, 1.0))
        .map("material", whole_map(last, "fraction of AP", "-", last.material, 1.0))
        .table("surface",
               {{"x", "um", scaled(surface.x, um)}, {"y", "um", scaled(surface.height, um)}})
        .set("width", scene.domain.width / um)
        .set("strip", std::get<Sandwich>(scene.morphology.shape).strip / um)
        .set("bottom", bottom / um)
        .set("top", top / um)
        .set("left_side", left / width)
        .set("right_side", 1.0 - right / width)
        .set("foot_side", foot / height)
        .set("head_side", 1.0 - head / height)
        .set("lowest_pressure", pressures.min / MPa)
        .set("largest_pressure", pressures.max / MPa)
        .caption({.grid = grid_text(scene), .step = step_text(scene), .revision = revision()});
    for (const char* panel : {"a", "b", "c"})
        figure.panel(panel, reports::Format::png, {.width = int(width), .height = int(height)});
    return {figure,
            {{"mean burn rate", burn->mean_burn_rate.back() / (cm / s), "cm/s"},
             {"strain norm, mean over 5 um about the peak", strain.mean, "-"},
             {"strain norm, peak on this grid", strain.value, "-"},
             {"pressure, mean over 5 um about the peak", pressure.mean / MPa, "MPa"},
             {"pressure, peak on this grid", pressure.value / MPa, "MPa"},
             finding(ledger::last_strain, *burn),
             finding(ledger::last_strain_about_peak, *burn),
             {finds::deviator_of_AP, deviator(last, true) / MPa, "MPa"},
             {finds::deviator_of_binder, deviator(last, false) / MPa, "MPa"}},
            {scene}};
}

ledger::Rows claims(const ledger::Evidence& evidence) {
    using namespace reports;
    const auto found = evidence.findings_of("fig07");
    const std::string as_read = "3 alpha K, c_p, strip of 60 um";
    const double ap = found(finds::deviator_of_AP), binder = found(finds::deviator_of_binder);
    return {
        judged(
            {"largest strain of the sandwich", "Fig. 7c", "fig07", "%", "as high as 50", 50.0, 5.0},
            {ledger::percent(found(ledger::last_strain.what)),
             {},
             as_read + "; this grid",
             ledger::times(
                 ledger::others(evidence.sandwich_readings, ledger::quantity::largest_strain),
                 100.0),
             fmt::format("A peak beside a singular corner grows with every refinement and has "
                         "no uncertainty; its mean over 5 um is {:.1f} %.",
                         ledger::percent(found(ledger::last_strain_about_peak.what))),
             "{:.1f}"}),
        judged(Statement{"stress is confined to AP", "Fig. 7b", "fig07",
                         "all of the stress response is restricted to AP",
                         fmt::format("deviatoric stress, root mean square: {:.3g} MPa in AP, "
                                     "{:.2g} MPa in binder",
                                     ap, binder),
                         as_read, binder < 0.05 * ap,
                         "Confined is read as below 5 %. Pressure is another matter: binder "
                         "carries that of the gas."})};
}

const Registered here{{.name = "fig07",
                       .figure = "Fig. 7",
                       .shows = "sandwich: maps of temperature, pressure, strain",
                       .physics = {physics::heat, physics::burning, physics::stress,
                                   physics::coupling, physics::reference_map, physics::sandwich},
                       .cost = {.draft = 8.0, .paper = 80.0},
                       .draw = fig07,
                       .burns = [](Fidelity f) { return std::vector{burning_sandwich(f, true)}; },
                       .claims = claims,
                       .claims_rest_on = LedgerRuns::sandwich}};

}  // namespace

}  // namespace crawford
