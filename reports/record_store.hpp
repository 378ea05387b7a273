/// Records on disk: what is there is not computed again, what was killed goes on.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "reports/record.hpp"

namespace crawford::reports {

/// JSON Lines, one file an experiment, in a directory of their own. A record is known by its
/// experiment, its setting and the fingerprint; of several the last one counts. A line that was
/// torn when its program was killed is dropped, as is any that cannot be understood.
class RecordStore {
public:
    /// Records that are added carry `fingerprint`, and only such are found. The directory is made
    /// when the first is added.
    RecordStore(std::filesystem::path directory, std::string fingerprint);

    /// The record of a run that is done, by the same fingerprint.
    std::optional<Record> find(const std::string& experiment, const Setting& setting);

    /// The newest record of this setting, whatever its fingerprint and ending.
    std::optional<Record> newest(const std::string& experiment, const Setting& setting);

    /// The newest record of the experiment at all.
    std::optional<Record> newest(const std::string& experiment);

    /// Removes its records: what they tell of is about to be written over.
    void forget(const std::string& experiment);

    /// Appends it, as one line, before it returns. The first to be added to a file sweeps out what
    /// other fingerprints have left there.
    /// \throws InputError if the file cannot be written.
    void add(Record record);

    const std::string& fingerprint() const { return fingerprint_; }

private:
    struct File {
        std::vector<Record> records;
        bool is_clean = true;  ///< all whole and of this fingerprint
    };

    File& file_of(const std::string& experiment);
    std::filesystem::path path_of(const std::string& experiment) const;

    std::filesystem::path directory_;
    std::string fingerprint_;
    std::map<std::string, File> files_;
    std::mutex mutex_;
};

/// Name of an experiment's file: "slab_AP_beta_3_alpha_K.jsonl" of "slab, AP, beta = 3 alpha K".
std::string record_file_name(const std::string& experiment);

}  // namespace crawford::reports
