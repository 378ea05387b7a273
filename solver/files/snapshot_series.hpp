/// The snapshots of a run:
/// one VTKHDF file a time, and the index that makes ParaView show them as one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/files/provenance.hpp"
#include "solver/files/snapshot.hpp"

namespace crawford {

class SnapshotSeries {
public:
    /// `<directory>/<name>_<step>.hdf` and `<directory>/<name>.hdf.series`; an index left by an
    /// earlier run is replaced with the first snapshot.
    SnapshotSeries(std::filesystem::path directory, std::string name, Provenance provenance);

    /// Goes on with the index on disk, if there is one, up to and including `time` [s].
    /// \throws InputError if the index is damaged.
    void resume(double time);

    /// Writes the file, then the index. A snapshot of the same step is replaced.
    /// \throws InputError if they cannot be written.
    void write(const Snapshot& snapshot);

private:
    struct Entry {
        std::string file;
        double time;
    };

    std::filesystem::path index() const { return directory_ / (name_ + ".hdf.series"); }
    void write_index() const;

    std::filesystem::path directory_;
    std::string name_;
    Provenance provenance_;
    std::vector<Entry> entries_;
};

}  // namespace crawford
