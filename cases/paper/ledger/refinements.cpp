#include "cases/paper/ledger/refinements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "cases/units.hpp"
#include "reports/extrapolate.hpp"
#include "reports/order.hpp"

namespace crawford::ledger {

namespace {

using namespace units;

constexpr double formal_order = 1.0;
constexpr auto diverging = "diverging";

const std::vector<Measure> of_pack = {mean_burn_rate_of_all,  mean_temperature,         mean_strain,
                                      mean_strain_about_peak, mean_pressure_about_peak, relief};
const std::vector<Measure> of_rigid_pack = {mean_burn_rate_of_all, mean_temperature, relief};
const std::vector<Measure> of_sandwich = {
    last_burn_rate,           last_temperature,     last_strain,      last_strain_about_peak,
    last_pressure_about_peak, outward_displacement, height_of_profile};
const std::vector<Measure> of_rigid_sandwich = {last_burn_rate, last_temperature,
                                                height_of_profile};

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
    return {{of, direction, subject, resolutions, used, true, pack ? of_pack : of_sandwich},
            {of + ", rigid", direction, subject, resolutions, used, false,
             pack ? of_rigid_pack : of_rigid_sandwich}};
}

reports::Refinement refinement(const Series& series, const Measure& measure,
                               const std::vector<double>& sizes,
                               const std::vector<std::shared_ptr<const Burn>>& burns) {
    reports::Refinement found{.quantity = measure.what,
                              .of = series.of,
                              .direction = series.direction,
                              .unit = measure.unit,
                              .sizes = sizes,
                              .size_unit = series.direction == "dt" ? "us" : "um"};
    found.used = sizes[series.used];
    for (const auto& burn : burns) found.values.push_back(measure.of(*burn));
    const auto limit = reports::extrapolate(sizes, found.values, formal_order);
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

std::vector<Series> all_series(Fidelity fidelity) {
    const bool draft = fidelity == Fidelity::draft;
    const double until = draft ? 0.04 : 0.1;
    const auto pack_grids =
        draft ? std::vector<Resolution>{{40, 32, 100 * us, 0.04},
                                        {50, 40, 100 * us, 0.04},
                                        {60, 48, 100 * us, 0.04}}
              : std::vector<Resolution>{
                    {60, 48, 50 * us, 0.135}, {90, 72, 50 * us, 0.135}, {120, 96, 50 * us, 0.135}};
    const auto pack_steps =
        draft ? varied({60, 48, 0, 0.04}, &Resolution::step, {120 * us, 100 * us, 80 * us})
              : varied({120, 96, 0, 0.135}, &Resolution::step, {75 * us, 50 * us, 25 * us});
    const Resolution sandwich =
        draft ? Resolution{32, 48, 80 * us, until} : Resolution{64, 96, 20 * us, until};
    const auto columns = varied(sandwich, &Resolution::nx,
                                draft ? std::vector{16, 32, 64} : std::vector{32, 64, 128});
    const auto rows = varied(sandwich, &Resolution::ny,
                             draft ? std::vector{24, 36, 48} : std::vector{48, 72, 96});
    const auto steps = varied(
        sandwich, &Resolution::step,
        draft ? std::vector{160 * us, 80 * us, 40 * us} : std::vector{80 * us, 40 * us, 20 * us});
    std::vector<Series> all;
    const auto add = [&](const std::vector<Series>& two) {
        all.insert(all.end(), two.begin(), two.end());
    };
    add(both("pack", "pack.toml", "x and y", pack_grids, 2));
    add(both("pack", "pack.toml", "dt", pack_steps, draft ? 1 : 2));
    add(both("burning sandwich", "sandwich.toml", "x", columns, 1));
    add(both("burning sandwich", "sandwich.toml", "y", rows, 2));
    add(both("burning sandwich", "sandwich.toml", "dt", steps, 2));
    return all;
}

std::vector<Scene> scenes_of(const Series& series) {
    std::vector<Scene> scenes;
    for (const Resolution& resolution : series.resolutions)
        scenes.push_back(series.scene(resolution));
    return scenes;
}

std::vector<reports::Refinement> refinements(const Series& series, const Request& request) {
    std::vector<double> sizes;
    std::vector<std::shared_ptr<const Burn>> burns;
    for (const Scene& scene : scenes_of(series)) {
        sizes.push_back(size_of(scene, series.direction));
        burns.push_back(kept_burn(scene, request));
    }
    std::vector<reports::Refinement> all;
    for (const Measure& measure : series.measures)
        all.push_back(refinement(series, measure, sizes, burns));
    return all;
}

namespace {

const reports::Refinement* find(const std::vector<reports::Refinement>& refinements,
                                const std::string& of, const std::string& quantity,
                                const std::string& direction) {
    const auto found = std::ranges::find_if(refinements, [&](const auto& r) {
        return r.of == of && r.quantity == quantity && r.direction == direction;
    });
    return found == refinements.end() ? nullptr : &*found;
}

}  // namespace

std::optional<double> index(const std::vector<reports::Refinement>& refinements,
                            const std::string& of, const std::string& quantity,
                            const std::string& direction) {
    const auto* found = find(refinements, of, quantity, direction);
    if (found == nullptr || found->verdict == diverging) return {};
    return found->index;
}

std::string divergence(const std::vector<reports::Refinement>& refinements, const std::string& of,
                       const std::string& quantity, const std::string& direction) {
    const auto* found = find(refinements, of, quantity, direction);
    if (found == nullptr || found->verdict != diverging) return {};
    std::vector<std::string> values;
    for (const double value : found->values) values.push_back(fmt::format("{:.4g}", value));
    return fmt::format("No interval from the grid, for it does not converge there: {}.",
                       fmt::join(values, ", "));
}

Packs packs(Fidelity fidelity) {
    if (fidelity == Fidelity::draft) return {{40, 32, 100 * us, 0.04}, {1, 2}};
    return {{60, 48, 50 * us, 0.135}, {1, 2, 3, 4, 5}};
}

namespace {

const Subject random_pack("random_pack.toml");

const std::vector<std::string> twice_the_flux = {"surface.heat_flux.AP=400 cal/(s cm2)",
                                                 "surface.heat_flux.binder=320 cal/(s cm2)"};

std::string seeded(unsigned long seed) {
    return fmt::format("morphology.seed={}", seed);
}

std::vector<std::string> with(std::vector<std::string> set, unsigned long seed) {
    set.push_back(seeded(seed));
    return set;
}

/// Adds the measures of one burn a seed, named "<of>: <measure>".
void add_spreads(std::vector<reports::Spread>& all, const std::string& of,
                 const std::vector<unsigned long>& seeds,
                 const std::vector<std::shared_ptr<const Burn>>& burns,
                 const std::vector<Measure>& measures) {
    for (const Measure& measure : measures) {
        reports::Spread& found = all.emplace_back();
        found.quantity = of + ": " + measure.what;
        found.unit = measure.unit;
        found.seeds = seeds;
        for (const auto& burn : burns) found.values.push_back(measure.of(*burn));
        found.mean = mean(found.values);
        found.deviation = deviation(found.values);
    }
}

}  // namespace

std::vector<Scene> scenes_of(const Packs& packs) {
    std::vector<Scene> scenes;
    for (const unsigned long seed : packs.seeds) {
        scenes.push_back(random_pack.coupled(packs.resolution, {seeded(seed)}));
        scenes.push_back(random_pack.rigid(packs.resolution, {seeded(seed)}));
        scenes.push_back(random_pack.coupled(packs.resolution, with(twice_the_flux, seed)));
    }
    return scenes;
}

std::vector<reports::Spread> spreads(const Packs& packs, const Request& request) {
    std::vector<std::shared_ptr<const Burn>> coupled, rigid, twice;
    for (const unsigned long seed : packs.seeds) {
        const auto burnt = [&](const Scene& scene) { return kept_burn(scene, request); };
        coupled.push_back(burnt(random_pack.coupled(packs.resolution, {seeded(seed)})));
        rigid.push_back(burnt(random_pack.rigid(packs.resolution, {seeded(seed)})));
        twice.push_back(burnt(random_pack.coupled(packs.resolution, with(twice_the_flux, seed))));
    }
    std::vector<reports::Spread> all;
    add_spreads(all, "pack", packs.seeds, coupled, of_pack);
    add_spreads(all, "pack, 2Q", packs.seeds, twice, of_pack);
    add_spreads(all, "pack, rigid", packs.seeds, rigid, of_rigid_pack);
    return all;
}

}  // namespace crawford::ledger
