#include <fmt/format.h>

#include <cmath>

#include "cases/paper/ledger/refinements.hpp"
#include "cases/paper/ledger/rows.hpp"
#include "cases/paper/ledger/subject.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/units.hpp"

namespace crawford::ledger {

namespace {

using reports::judged;
using reports::OtherReading;
using reports::Statement;
using namespace units;
using Rows = std::vector<reports::LedgerRow>;

const std::string as_read = "3 alpha K, c_p, strip of 60 um";

/// Of x and y together, and of dt.
reports::Uncertainty uncertainty(const std::vector<reports::Refinement>& refinements,
                                 const Measure& measure) {
    const auto of = [&](const char* direction) {
        return index(refinements, "burning sandwich", measure.what, direction);
    };
    const auto x = of("x"), y = of("y");
    return {.grid = x && y ? std::optional(std::hypot(*x, *y)) : std::nullopt, .step = of("dt")};
}

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

reports::LedgerRow strain(const Burn& burn, const reports::ReadingMatrix& matrix) {
    auto in_percent = others(matrix, "largest strain");
    for (OtherReading& other : in_percent) other.value *= 100.0;
    return judged(
        {"largest strain of the sandwich", "Fig. 7c", "fig07", "%", "as high as 50", 50.0, 5.0},
        {100.0 * last_strain.of(burn),
         {},
         as_read + "; this grid",
         in_percent,
         fmt::format("A peak beside a singular corner grows with every refinement and has no "
                     "uncertainty; its mean over 5 um is {:.1f} %.",
                     100.0 * last_strain_about_peak.of(burn)),
         "{:.1f}"});
}

reports::LedgerRow stress_in_AP(const Burn& burn) {
    const double ap = deviator(burn.last, true) / MPa, binder = deviator(burn.last, false) / MPa;
    return judged(Statement{"stress is confined to AP", "Fig. 7b", "fig07",
                            "all of the stress response is restricted to AP",
                            fmt::format("deviatoric stress, root mean square: {:.3g} MPa in AP, "
                                        "{:.2g} MPa in binder",
                                        ap, binder),
                            as_read, binder < 0.05 * ap,
                            "Confined is read as below 5 %. Pressure is another matter: binder "
                            "carries that of the gas."});
}

reports::LedgerRow cooling(const Burn& coupled, const Burn& rigid) {
    const int top = coupled.last.temperature.rows() - 1;
    const int side = coupled.last.temperature.columns() - 1;
    const auto change = [&](int i) {
        return coupled.last.temperature(i, top) - rigid.last.temperature(i, top);
    };
    return judged(Statement{
        "mechanics cools the surface, binder more than AP", "Fig. 10a", "fig10",
        "a drop is observed, much higher in the binder",
        fmt::format("{:+.2f} K amid the strip, {:+.2f} K amid AP", change(0), change(side)),
        as_read, change(0) < 0.0 && change(side) < 0.0 && change(0) < change(side),
        "Both must fall, binder by more. Case model-form says how much of it is c_p counted "
        "twice."});
}

reports::LedgerRow slowing(const Burn& coupled, const Burn& rigid,
                           const reports::ReadingMatrix& matrix) {
    const double change = 100.0 * (last_burn_rate.of(coupled) / last_burn_rate.of(rigid) - 1.0);
    double with_c_v = 0.0;
    for (const OtherReading& other : others(matrix, "change of burn rate"))
        if (other.reading.starts_with("c_v (")) with_c_v = other.value;
    return judged(Statement{"mechanics slows the burning of the sandwich", "Fig. 10b", "fig10",
                            "causes a drop in the propellant burn rate",
                            fmt::format("{:+.2f} %", change), as_read, change < 0.0,
                            fmt::format("With c_v in place of c_p {:+.2f} %: the paper's sign is "
                                        "right, its size hangs on a heat capacity counted twice.",
                                        with_c_v)});
}

}  // namespace

Rows rows_of_sandwich(const Request& request, const std::vector<reports::Refinement>& refinements,
                      const reports::ReadingMatrix& matrix) {
    const auto coupled = kept_burn(burning_sandwich(request.fidelity, true), request);
    const auto rigid = kept_burn(burning_sandwich(request.fidelity, false), request);
    return {strain(*coupled, matrix), stress_in_AP(*coupled), cooling(*coupled, *rigid),
            slowing(*coupled, *rigid, matrix),
            judged({"largest outward displacement, binder", "Fig. 11", "fig11", "um", "roughly 8",
                    8.0, 0.5 + 0.8},
                   {height_of_profile.of(*coupled), uncertainty(refinements, height_of_profile),
                    as_read + "; height above the first point, as drawn",
                    others(matrix, "height of the profile"),
                    fmt::format(
                        "The material itself has moved out by {:.1f} um. {}",
                        outward_displacement.of(*coupled),
                        divergence(refinements, "burning sandwich", height_of_profile.what, "x")),
                    "{:.1f}"})};
}

}  // namespace crawford::ledger
