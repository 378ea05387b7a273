#include "cases/paper/ledger/packs.hpp"

#include <fmt/format.h>

#include "cases/units.hpp"

namespace crawford::ledger {

namespace {

using namespace units;

const std::vector<std::string> twice_the_flux = {"surface.heat_flux.AP=400 cal/(s cm2)",
                                                 "surface.heat_flux.binder=320 cal/(s cm2)"};

/// Burns of one pack: with mechanics, under twice the flux, and as a rigid conductor.
struct Part {
    std::string of;
    std::vector<Measure> measures;
};
std::vector<Part> parts() {
    return {{of_pack, pack_measures()},
            {of_pack_2Q, pack_measures()},
            {of_rigid_pack, rigid_pack_measures()}};
}

/// In the order of parts().
std::vector<Scene> scenes_of(const Resolution& resolution, unsigned long seed) {
    const Subject pack("random_pack.toml");
    const std::string seeded = fmt::format("morphology.seed={}", seed);
    std::vector<std::string> twice = twice_the_flux;
    twice.push_back(seeded);
    return {pack.coupled(resolution, {seeded}), pack.coupled(resolution, twice),
            pack.rigid(resolution, {seeded})};
}

Run run_of(const Resolution& resolution, unsigned long seed) {
    auto scenes = scenes_of(resolution, seed);
    return {"packs", with(reports::Setting().set("seed", long(seed)), resolution), scenes,
            [scenes](const Request& request) {
                reports::Measurement found;
                const auto all = parts();
                for (size_t k = 0; k < all.size(); ++k) {
                    const auto burn = kept_burn(scenes[k], request);
                    for (const Measure& measure : all[k].measures)
                        found.value(spread_name(all[k].of, measure),
                                    reports::Amount{measure.of(*burn), measure.unit});
                }
                return found;
            }};
}

}  // namespace

std::string spread_name(const std::string& of, const Measure& measure) {
    return of + ": " + measure.what;
}

Packs packs(Fidelity fidelity) {
    if (fidelity == Fidelity::draft) return {{40, 32, 100 * us, 0.04}, {1, 2}};
    return {{60, 48, 50 * us, 0.135}, {1, 2, 3, 4, 5}};
}

std::vector<Run> runs(const Packs& packs) {
    std::vector<Run> runs;
    for (const unsigned long seed : packs.seeds) runs.push_back(run_of(packs.resolution, seed));
    return runs;
}

std::vector<reports::Spread> spreads(const Packs& packs, const Records& records) {
    std::vector<reports::Measurement> measurements;
    for (const Run& run : runs(packs)) measurements.push_back(found(records(run)));
    std::vector<reports::Spread> all;
    for (const Part& part : parts())
        for (const Measure& measure : part.measures) {
            reports::Spread& spread = all.emplace_back();
            spread.quantity = spread_name(part.of, measure);
            spread.unit = measure.unit;
            spread.seeds = packs.seeds;
            for (const auto& one : measurements)
                spread.values.push_back(value(one, spread.quantity));
            spread.mean = mean(spread.values);
            spread.deviation = deviation(spread.values);
        }
    return all;
}

}  // namespace crawford::ledger
