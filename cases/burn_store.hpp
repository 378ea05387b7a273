/// Burns that figures and the ledger look at, kept on disk: each is made once, and what was cut off
/// goes on from its last checkpoint.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "cases/registry.hpp"
#include "solver/files/snapshot.hpp"

namespace crawford {

/// What a burn has left. Courses have one value a step; those of what the scene does not compute
/// are zero.
struct Burn {
    Scene scene;
    std::filesystem::path directory;          ///< its history, checkpoints, last snapshot, manifest
    std::vector<double> time;                 ///< [s]
    std::vector<double> mean_burn_rate;       ///< [m/s]
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

/// Burns the scene to its end, or takes what lies finished under request.out/burns: a burn of the
/// same scene by the same solver. Who asks for one that is under way, in whatever process, waits
/// for it. Without request.out the burn lies in a directory that this program removes when it ends.
/// \throws NumericalFailure if the burn fails, and at once if it is known to.
std::shared_ptr<const Burn> kept_burn(const Scene& scene, const Request& request);

/// Whether kept_burn would return, or fail, without burning.
bool is_kept(const Scene& scene, const std::filesystem::path& out);

/// Rough wall time of a burn from its start on one core [s], to tell the long from the short.
double expected_seconds(const Scene& scene);

/// "AP/binder pack, 72 %, 120 x 96, 25 us", for progress.
std::string burn_title(const Scene& scene);

}  // namespace crawford
