#include "solver/files/snapshot_series.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "base/json_problem.hpp"
#include "solver/files/vtkhdf.hpp"

namespace crawford {

using Json = nlohmann::ordered_json;

SnapshotSeries::SnapshotSeries(std::filesystem::path directory, std::string name,
                               Provenance provenance)
    : directory_(std::move(directory)),
      name_(std::move(name)),
      provenance_(std::move(provenance)) {}

void SnapshotSeries::resume(double time) {
    std::ifstream file(index());
    if (!file) return;
    try {
        const Json series = Json::parse(file);
        for (const Json& entry : series.at("files"))
            if (entry.at("time").get<double>() <= time)
                entries_.push_back({entry.at("name"), entry.at("time")});
    } catch (const Json::exception& error) {
        throw InputError(
            fmt::format("cannot go on with {}: {}; remove it or choose another "
                        "directory",
                        index().string(), json_problem(error.what())));
    }
}

void SnapshotSeries::write(const Snapshot& snapshot) {
    const std::string file = fmt::format("{}_{:06d}.hdf", name_, snapshot.step);
    write_vtkhdf(directory_ / file, snapshot, provenance_);
    std::erase_if(entries_, [&](const Entry& entry) { return entry.file == file; });
    entries_.push_back({file, snapshot.time});
    write_index();
}

void SnapshotSeries::write_index() const {
    Json series = {{"file-series-version", "1.0"}, {"files", Json::array()}};
    for (const Entry& entry : entries_)
        series["files"].push_back({{"name", entry.file}, {"time", entry.time}});
    write_file(index(), series.dump(2) + '\n');
}

}  // namespace crawford
