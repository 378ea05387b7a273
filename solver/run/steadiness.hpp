/// When a burning solid counts as steady.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "solver/files/sample.hpp"
#include "solver/scene/scene.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

/// The quantity watched is the mean burn rate. Where the scene prescribes it, it cannot tell, and
/// the largest temperature is watched instead; without heat, the largest strain.
///
/// It is steady when over the last millisecond, or over a hundredth of the relaxation time 4 D/r_b^2
/// where that is longer, its largest and smallest value differ by less than
/// `until_steady` of their mean: the range, because the difference of two ends vanishes at every
/// turning point of an oscillation. And it is judged only once every column of a regressing surface
/// has burnt down one thermal layer D/r_b of the slowest material to adapt (D its diffusivity, r_b
/// the mean rate): before, a part that has not ignited yet leaves the mean of the others at rest,
/// and the cold start itself is at rest.
///
/// Being steady to a tolerance is not being that close to the end: the layer relaxes over about 4
/// D/r_b^2 (binder at 0.45 cm/s: 47 ms), so what is left to go is some 50 times the change per
/// millisecond.
class Steadiness {
public:
    explicit Steadiness(const Scene& scene);

    void record(const State& state, const Summary& summary);

    /// Whether the run may end; never, where the scene does not ask for it.
    bool reached() const { return reached_; }

    /// What is looked back at, to be kept with a checkpoint so that a restarted run ends where the
    /// unbroken one does.
    std::vector<Sample> window() const { return {window_.begin(), window_.end()}; }
    void resume(const std::vector<Sample>& window) { window_.assign(window.begin(), window.end()); }

private:
    double watched(const Summary& summary) const;
    bool started(const State& state, const Summary& summary) const;
    double window_length(const Summary& summary) const;
    bool at_rest(double length) const;
    bool covers(const Sample& sample, double length) const;

    Physics physics_;
    std::optional<double> tolerance_;
    double diffusivity_;  ///< largest of the materials [m^2/s]
    std::deque<Sample> window_;
    bool reached_ = false;
};

}  // namespace crawford
