#include "program/burning.hpp"

#include "cases/kept_burn.hpp"

namespace crawford {

std::vector<Job> burnings(const std::vector<Scene>& scenes, const std::filesystem::path& out) {
    std::vector<Job> jobs;
    for (const Scene& scene : united(scenes)) {
        if (kept_runs(out).has(scene)) continue;
        jobs.push_back(
            {"burning " + run_title(scene), expected_seconds(scene),
             [scene, out](const Job::Progress& progress) { kept_runs(out).get(scene, progress); }});
    }
    return jobs;
}

}  // namespace crawford
