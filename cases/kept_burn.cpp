#include "cases/kept_burn.hpp"

#include "base/scratch.hpp"

namespace crawford {

KeptRuns kept_runs(const std::filesystem::path& out) {
    if (!out.empty()) return KeptRuns(out / "burns");
    static const Scratch scratch;
    return KeptRuns(scratch.path());
}

std::shared_ptr<const Burn> kept_burn(const Scene& scene, const Request& request) {
    const auto progress = [&](double done) { request.progress(run_title(scene), done); };
    return kept_runs(request.out)
        .get(scene, request.progress ? progress : std::function<void(double)>());
}

}  // namespace crawford
