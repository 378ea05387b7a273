/// The store of kept runs: each is made once, for all who look at it, and what was cut off goes on
/// from its last checkpoint.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "solver/files/snapshot.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

/// What a run has left. Courses have one value a step; those of what the scene does not compute are
/// zero.
struct KeptRun {
    Scene scene;                              ///< as it was asked for
    std::filesystem::path directory;          ///< its history, checkpoints, last snapshot, manifest
    std::vector<double> time;                 ///< [s]
    std::vector<double> mean_burn_rate;       ///< [m/s]
    std::vector<double> regression_rate;      ///< drop of the mean height per time [m/s]
    std::vector<double> largest_temperature;  ///< [K]
    std::vector<double> largest_strain;       ///< on this grid
    std::vector<double> strain_about_peak;    ///< mean over peak_radius about it
    std::vector<double> largest_pressure;     ///< on this grid [Pa]
    std::vector<double> pressure_about_peak;  ///< likewise [Pa]
    Snapshot last;

    /// The state at the checkpoint that lies within half a step of `time` [s].
    /// \throws InputError if there is none: output.checkpoint_every decides.
    Snapshot at(double time) const;
};

/// A directory of runs. A run is known by identity_of() its scene (run_identity.hpp) and by the
/// sources of the solver; what it writes is a request to it.
class KeptRuns {
public:
    explicit KeptRuns(std::filesystem::path place) : place_(std::move(place)) {}

    /// Burns the scene to its end, or takes the run of this identity that lies finished, if it has
    /// all the output that is asked for; if it lacks some it is burnt again, with what it had and
    /// what is asked for. Who asks for a run that is under way, in whatever process, waits for it.
    /// \param progress told after each step how much is done, 0 to 1
    /// \throws NumericalFailure if the run fails. Asked again, it is tried again from its last
    /// checkpoint.
    std::shared_ptr<const KeptRun> get(const Scene& scene,
                                       const std::function<void(double)>& progress = {}) const;

    /// Whether get() would return without burning.
    bool has(const Scene& scene) const;

private:
    std::filesystem::path directory_of(const Scene& scene) const;

    std::filesystem::path place_;
};

}  // namespace crawford
