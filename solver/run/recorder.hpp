/// Everything a run writes on its way: history, snapshots, checkpoints.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/files/checkpoint.hpp"
#include "solver/files/history.hpp"
#include "solver/files/provenance.hpp"
#include "solver/files/snapshot_series.hpp"
#include "solver/run/reduction.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

/// Whether a multiple of `interval` lies in (before, after]: with times alone, so that a restarted
/// run writes when the unbroken one does.
bool is_due(double before, double after, double interval);

class Recorder {
public:
    /// For a run that begins with the state of `simulation`: at step 0 the files are new, later
    /// they go on from there.
    /// \throws InputError if they cannot be written or gone on with.
    Recorder(std::filesystem::path directory, std::string name, const Reduction& reduction,
             const Simulation& simulation);

    /// Writes what is due after a step that began at time `before` [s]. At a checkpoint the
    /// simulation forgets its factorisation, as a restarted run has none.
    void record(Simulation& simulation, const Summary& summary, double before,
                const RunMemory& memory);

    /// Writes snapshot and checkpoint of the present state and its row of the history, unless they are
    /// written already.
    /// \returns the checkpoint's file.
    std::filesystem::path keep(const Simulation& simulation, const RunMemory& memory);

private:
    void take_snapshot(const Simulation& simulation);
    std::filesystem::path take_checkpoint(const Simulation& simulation, const RunMemory& memory);

    std::filesystem::path directory_;
    std::string name_;
    Widening widening_;
    Provenance computed_;  ///< goes into checkpoints
    Output output_;
    History history_;
    SnapshotSeries snapshots_;
    long last_snapshot_ = -1;  ///< step
    bool owes_a_row_ = false;  ///< the last step's was not due
};

}  // namespace crawford
