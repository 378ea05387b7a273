#include "program/burning.hpp"

#include <set>
#include <string>

#include "cases/burn_store.hpp"
#include "solver/scene/write_scene.hpp"

namespace crawford {

std::vector<Job> burnings(const std::vector<Scene>& scenes, Fidelity fidelity,
                          const std::filesystem::path& out) {
    std::vector<Job> tasks;
    std::set<std::string> seen;
    for (const Scene& scene : scenes) {
        if (!seen.insert(to_toml(scene)).second || is_kept(scene, out)) continue;
        tasks.push_back({"burning " + burn_title(scene), expected_seconds(scene),
                         [scene, fidelity, out](const Job::Progress& progress) {
                             kept_burn(scene, {.fidelity = fidelity,
                                               .out = out,
                                               .progress = [&](const std::string&, double done) {
                                                   progress(done);
                                               }});
                         }});
    }
    return tasks;
}

}  // namespace crawford
