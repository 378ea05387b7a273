#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cases/paper/ledger/refinements.hpp"
#include "cases/paper/ledger/rows.hpp"
#include "cases/paper/ledger/subject.hpp"
#include "cases/scenes/pack.hpp"

namespace crawford::ledger {

namespace {

using reports::half_digit;
using reports::judged;
using reports::OtherReading;
using reports::Statement;
using Rows = std::vector<reports::LedgerRow>;

const std::string as_read = "3 alpha K, c_p; mean of the whole run, ignition and all";

const reports::Spread& spread_of(const reports::Ledger& found, const std::string& name) {
    const auto spread = std::ranges::find(found.spreads, name, &reports::Spread::quantity);
    if (spread == found.spreads.end())
        throw std::logic_error("the ledger has no spread of " + name);
    return *spread;
}

/// Two standard deviations from pack to pack: the paper's own pack is not published.
double of_packs(const reports::Ledger& found, const std::string& name) {
    return 2.0 * spread_of(found, name).deviation;
}

/// The same of what mechanics changes, pack by pack: what two runs of one pack share cancels.
template <class Change>
reports::Uncertainty of_change(const reports::Ledger& found, const Measure& measure,
                               const Change& change) {
    const auto& coupled = spread_of(found, std::string("pack: ") + measure.what).values;
    const auto& rigid = spread_of(found, std::string("pack, rigid: ") + measure.what).values;
    std::vector<double> changes;
    for (size_t k = 0; k < coupled.size(); ++k) changes.push_back(change(coupled[k], rigid[k]));
    return {.packs = 2.0 * deviation(changes)};
}

double difference(double coupled, double rigid) {
    return coupled - rigid;
}

double per_cent(double coupled, double rigid) {
    return 100.0 * (coupled / rigid - 1.0);
}

/// `of` is "pack", "pack, rigid" or "pack, 2Q"; what doubles the flux was refined without.
reports::Uncertainty uncertainty(const reports::Ledger& found, const std::string& of,
                                 const Measure& measure) {
    const std::string refined = of == "pack, 2Q" ? "pack" : of;
    return {.grid = index(found.refinements, refined, measure.what, "x and y"),
            .step = index(found.refinements, refined, measure.what, "dt"),
            .packs = of_packs(found, of + ": " + measure.what)};
}

std::string divergence_of(const reports::Ledger& found, const std::string& of,
                          const Measure& measure) {
    return divergence(found.refinements, of, measure.what, "x and y");
}

std::vector<OtherReading> plus(std::vector<OtherReading> others, double offset) {
    for (OtherReading& other : others) other.value += offset;
    return others;
}

std::vector<OtherReading> before(OtherReading first, std::vector<OtherReading> others) {
    others.insert(others.begin(), std::move(first));
    return others;
}

const char* const since = "mean from 20 ms on";

Rows temperatures(const reports::Ledger& found, const reports::ReadingMatrix& matrix,
                  const Burn& coupled, const Burn& rigid) {
    constexpr double cold = 300.0;  // [K]
    const double with = mean_temperature.of(coupled), without = mean_temperature.of(rigid);
    const double later = course(coupled.time, coupled.largest_temperature).mean;
    const double rigid_later = course(rigid.time, rigid.largest_temperature).mean;
    return {judged({"mean of the largest temperature, thermal", "Fig. 15a", "fig15", "K", "975.9",
                    975.9, half_digit("975.9")},
                   {without, uncertainty(found, "pack, rigid", mean_temperature), as_read,
                    before({since, rigid_later},
                           plus(others(matrix, "rise of largest T, rigid"), cold)),
                    divergence_of(found, "pack, rigid", mean_temperature), "{:.1f}"}),
            judged({"mean of the largest temperature, thermo-mechanical", "Fig. 15a", "fig15", "K",
                    "965.4", 965.4, half_digit("965.4")},
                   {with, uncertainty(found, "pack", mean_temperature), as_read,
                    before({since, later}, plus(others(matrix, "rise of largest T"), cold)),
                    divergence_of(found, "pack", mean_temperature), "{:.1f}"}),
            judged({"their difference", "Fig. 15a", "fig15", "K", "-10.5", -10.5, 0.1},
                   {difference(with, without),
                    of_change(found, mean_temperature, difference),
                    as_read,
                    {{since, later - rigid_later}},
                    "Of two runs of one pack on one grid: what they share cancels.",
                    "{:.1f}"})};
}

Rows burn_rates(const reports::Ledger& found, const reports::ReadingMatrix& matrix,
                const Burn& coupled, const Burn& rigid) {
    const double with = mean_burn_rate_of_all.of(coupled),
                 without = mean_burn_rate_of_all.of(rigid);
    const double later = 100.0 * course(coupled.time, coupled.mean_burn_rate).mean;
    const double rigid_later = 100.0 * course(rigid.time, rigid.mean_burn_rate).mean;
    return {judged({"mean burn rate, thermal", "Fig. 15b", "fig15", "cm/s", "0.449", 0.449,
                    half_digit("0.449")},
                   {without, uncertainty(found, "pack, rigid", mean_burn_rate_of_all), as_read,
                    before({since, rigid_later}, others(matrix, "burn rate, rigid")),
                    fmt::format(
                        "From 20 ms on {:.4f}. The specific heat is not printed, and the rate goes "
                        "roughly as its inverse.",
                        rigid_later),
                    "{:.4f}"}),
            judged({"mean burn rate, thermo-mechanical", "Fig. 15b", "fig15", "cm/s", "0.42", 0.42,
                    half_digit("0.42")},
                   {with, uncertainty(found, "pack", mean_burn_rate_of_all), as_read,
                    before({since, later}, others(matrix, "burn rate")),
                    fmt::format("From 20 ms on {:.4f}.", later), "{:.4f}"}),
            judged({"change of the burn rate by mechanics", "Fig. 15b", "fig15", "%", "-6.5",
                    100.0 * (0.42 / 0.449 - 1.0), 100.0 * half_digit("0.42") / 0.449},
                   {per_cent(with, without), of_change(found, mean_burn_rate_of_all, per_cent),
                    as_read, others(matrix, "change of burn rate"),
                    "With c_v in place of c_p most of it is gone: case model-form.", "{:.2f}"})};
}

/// Strains are printed in per cent.
double percent(double strain) {
    return 100.0 * strain;
}

std::vector<OtherReading> percent(std::vector<OtherReading> others) {
    for (OtherReading& other : others) other.value = percent(other.value);
    return others;
}

/// A peak does not converge: only other packs are in its interval.
reports::Uncertainty uncertainty_of_peak(const reports::Ledger& found, const std::string& of) {
    return {.packs = percent(of_packs(found, of + ": " + mean_strain.what))};
}

reports::LedgerRow mean_peak(const reports::Claim& claim, const Burn& burn,
                             const reports::Uncertainty& uncertainty, const std::string& grids,
                             const std::vector<OtherReading>& others) {
    const double about_peak = percent(mean_strain_about_peak.of(burn));
    return judged(claim,
                  {percent(mean_strain.of(burn)), uncertainty, as_read + "; this grid",
                   before({"the mean over 5 um about the peak", about_peak}, others),
                   fmt::format("A peak in a corner has no limit; over 5 um about it {:.1f} %. {}",
                               about_peak, grids),
                   "{:.1f}"});
}

Rows strains(const reports::Ledger& found, const reports::ReadingMatrix& matrix,
             const Burn& coupled, const Burn& twice) {
    return {
        mean_peak({"mean of the largest strain", "Fig. 16", "fig16", "%", "31.6", 31.6,
                   half_digit("31.6")},
                  coupled, uncertainty_of_peak(found, "pack"),
                  divergence_of(found, "pack", mean_strain),
                  percent(others(matrix, "largest strain"))),
        mean_peak({"mean of the largest strain, 2Q", "Fig. 17b", "fig17", "%", "37.24", 37.24,
                   half_digit("37.24")},
                  twice, uncertainty_of_peak(found, "pack, 2Q"), {}, {}),
        judged({"highest peak of strain, 2Q", "Fig. 17b", "fig17", "%", "as high as 60", 60.0, 5.0},
               {percent(std::ranges::max(twice.largest_strain)),
                {},
                "3 alpha K, c_p; this grid",
                {},
                "A single cell at a single time.",
                "{:.0f}"}),
        judged(Statement{"doubled flux raises the mean of the largest strain", "Fig. 17b", "fig17",
                         "31.6 % to 37.24 %",
                         fmt::format("{:.1f} % to {:.1f} %", percent(mean_strain.of(coupled)),
                                     percent(mean_strain.of(twice))),
                         as_read, mean_strain.of(twice) > mean_strain.of(coupled),
                         "Two runs of one pack on one grid."})};
}

reports::LedgerRow place_of_peaks(const Burn& coupled) {
    int in_binder = 0;
    const auto snapshots = four_times(coupled);
    for (const Snapshot& snapshot : snapshots) {
        const auto& strain = snapshot.strain_norm.values();
        const auto k = std::ranges::max_element(strain) - strain.begin();
        if (snapshot.material.values()[size_t(k)] < 0.5) ++in_binder;
    }
    return judged(Statement{
        "peak strains occur in binder between AP particles", "Fig. 13c", "fig13",
        "in thin binder regions in between AP particles",
        fmt::format("the peak lies in binder at {} of {} times", in_binder, snapshots.size()),
        "at the four times of Fig. 13", in_binder == int(snapshots.size()),
        "By the volume fraction of the cell that holds it."});
}

}  // namespace

std::vector<reports::OtherReading> others(const reports::ReadingMatrix& matrix,
                                          const std::string& quantity) {
    const auto column = std::ranges::find(matrix.quantities, quantity, &reports::Quantity::name);
    if (column == matrix.quantities.end())
        throw std::logic_error(fmt::format("{} has no {}", matrix.title, quantity));
    const auto k = size_t(column - matrix.quantities.begin());
    auto runs = matrix.runs;
    std::ranges::stable_sort(runs, {}, [](const auto& run) { return run.set.size(); });
    std::vector<OtherReading> others;
    for (const auto& run : runs)
        if (!run.set.empty() && std::isfinite(run.values[k]))
            others.push_back({run.reading + " (" + matrix.grid + ")", run.values[k]});
    return others;
}

Rows rows_of_pack(const Request& request, const reports::Ledger& found,
                  const reports::ReadingMatrix& matrix) {
    const auto burn = [&](const PackBurning& burning) {
        return kept_burn(burning_pack(request.fidelity, burning), request);
    };
    const auto coupled = burn({}), rigid = burn({.mechanics = false}), twice = burn({.flux = 2.0});
    Rows rows = temperatures(found, matrix, *coupled, *rigid);
    const auto add = [&](const Rows& more) { rows.insert(rows.end(), more.begin(), more.end()); };
    add(burn_rates(found, matrix, *coupled, *rigid));
    add({judged(
        {"mean burn rate, 2Q", "Fig. 17a", "fig17", "cm/s", "0.81", 0.81, half_digit("0.81")},
        {mean_burn_rate_of_all.of(*twice),
         uncertainty(found, "pack, 2Q", mean_burn_rate_of_all),
         as_read,
         {{since, 100.0 * course(twice->time, twice->mean_burn_rate).mean}},
         {},
         "{:.4f}"})});
    add(strains(found, matrix, *coupled, *twice));
    add({place_of_peaks(*coupled)});
    return rows;
}

}  // namespace crawford::ledger
