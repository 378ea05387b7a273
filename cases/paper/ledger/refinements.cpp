#include "cases/paper/ledger/refinements.hpp"

#include <algorithm>
#include <cmath>

#include "cases/units.hpp"
#include "reports/default_estimate.hpp"
#include "reports/order.hpp"

namespace crawford::ledger {

namespace {

using namespace units;

constexpr double formal_order = 1.0;

/// The size [um or us] that a direction refines.
double size_of(const Scene& scene, const std::string& direction) {
    if (direction == "dt") return scene.time.step / us;
    if (direction == "y") return scene.domain.depth / scene.domain.ny / um;
    return scene.domain.width / scene.domain.nx / um;
}

/// `base` with one of its sizes varied.
template <class Size>
std::vector<Resolution> varied(Resolution base, Size Resolution::*size,
                               const std::vector<Size>& values) {
    std::vector<Resolution> all;
    for (const Size value : values) {
        base.*size = value;
        all.push_back(base);
    }
    return all;
}

std::vector<Series> both(const std::string& of, const std::string& file,
                         const std::string& direction, const std::vector<Resolution>& resolutions,
                         size_t used) {
    const bool pack = of == "pack";
    // As often as figures keep theirs, so that burns with the grid and step of a figure are shared.
    const Subject subject(file, pack ? 5 * ms : 10 * ms);
    const std::string experiment = pack ? "ledger-pack-refinement" : "ledger-sandwich-refinement";
    return {{experiment, of, direction, subject, resolutions, used, true,
             pack ? pack_measures() : sandwich_measures()},
            {experiment, of + ", rigid", direction, subject, resolutions, used, false,
             pack ? rigid_pack_measures() : rigid_sandwich_measures()}};
}

std::vector<Series> joined(const std::vector<std::vector<Series>>& parts) {
    std::vector<Series> all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

Run run_of(const Series& series, const Resolution& resolution) {
    const std::string solid = series.mechanics ? "thermo-mechanical" : "rigid";
    const Scene scene = series.scene(resolution);
    return {series.experiment,
            with(reports::Setting().set("solid", solid), resolution),
            {scene},
            [scene, measures = series.measures](const Request& request) {
                return measured(*kept_burn(scene, request), measures);
            }};
}

reports::Refinement refinement(const Series& series, const Measure& measure,
                               const std::vector<double>& sizes,
                               const std::vector<reports::Measurement>& runs) {
    reports::Refinement found{.quantity = measure.what,
                              .of = series.of,
                              .direction = series.direction,
                              .unit = measure.unit,
                              .sizes = sizes,
                              .size_unit = series.direction == "dt" ? "us" : "um"};
    found.used = sizes[series.used];
    for (const auto& run : runs) found.values.push_back(value(run, measure.what));
    const auto limit = reports::default_limit(sizes, found.values, formal_order);
    if (std::isnan(limit.value)) {
        found.verdict = "no change";
        found.index = 0.0;
        return found;
    }
    found.order = limit.observed;
    found.extrapolated = limit.value;
    found.index = limit.safety * std::abs(found.values[series.used] - limit.value);
    std::vector<reports::Level> differences;
    for (size_t k = 0; k + 1 < sizes.size(); ++k)
        differences.push_back({int(k), sizes[k], std::abs(found.values[k] - found.values[k + 1])});
    const bool swings =
        (found.values[0] - found.values[1]) * (found.values[1] - found.values[2]) < 0.0;
    found.verdict = swings                  ? "oscillating"
                    : limit.observed <= 0.0 ? diverging
                    : limit.safety < 3.0    ? "monotone"
                                            : "not asymptotic";
    return found;
}

}  // namespace

std::vector<Series> pack_series(Fidelity fidelity) {
    const bool draft = fidelity == Fidelity::draft;
    const auto grids =
        draft ? std::vector<Resolution>{{40, 32, 100 * us, 0.04},
                                        {50, 40, 100 * us, 0.04},
                                        {60, 48, 100 * us, 0.04}}
              : std::vector<Resolution>{
                    {60, 48, 50 * us, 0.135}, {90, 72, 50 * us, 0.135}, {120, 96, 50 * us, 0.135}};
    const auto steps =
        draft ? varied({60, 48, 0, 0.04}, &Resolution::step, {120 * us, 100 * us, 80 * us})
              : varied({120, 96, 0, 0.135}, &Resolution::step, {75 * us, 50 * us, 25 * us});
    return joined({both("pack", "pack.toml", "x and y", grids, 2),
                   both("pack", "pack.toml", "dt", steps, draft ? 1 : 2)});
}

std::vector<Series> sandwich_series(Fidelity fidelity) {
    const bool draft = fidelity == Fidelity::draft;
    const Resolution sandwich =
        draft ? Resolution{32, 48, 80 * us, 0.04} : Resolution{64, 96, 20 * us, 0.1};
    const auto columns = varied(sandwich, &Resolution::nx,
                                draft ? std::vector{16, 32, 64} : std::vector{32, 64, 128});
    const auto rows = varied(sandwich, &Resolution::ny,
                             draft ? std::vector{24, 36, 48} : std::vector{48, 72, 96});
    const auto steps = varied(
        sandwich, &Resolution::step,
        draft ? std::vector{160 * us, 80 * us, 40 * us} : std::vector{80 * us, 40 * us, 20 * us});
    return joined({both("burning sandwich", "sandwich.toml", "x", columns, 1),
                   both("burning sandwich", "sandwich.toml", "y", rows, 2),
                   both("burning sandwich", "sandwich.toml", "dt", steps, 2)});
}

std::vector<Run> runs(const Series& series) {
    std::vector<Run> runs;
    for (const Resolution& resolution : series.resolutions)
        runs.push_back(run_of(series, resolution));
    return runs;
}

std::vector<reports::Refinement> refinements(const Series& series, const Records& records) {
    std::vector<double> sizes;
    std::vector<reports::Measurement> measurements;
    for (const Run& run : runs(series)) {
        sizes.push_back(size_of(run.scenes.front(), series.direction));
        measurements.push_back(found(records(run)));
    }
    std::vector<reports::Refinement> all;
    for (const Measure& measure : series.measures)
        all.push_back(refinement(series, measure, sizes, measurements));
    return all;
}

}  // namespace crawford::ledger
