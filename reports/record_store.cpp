#include "reports/record_store.hpp"

#include <cctype>
#include <fstream>
#include <stdexcept>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "reports/record_json.hpp"

namespace crawford::reports {

namespace {

using Json = nlohmann::ordered_json;

std::optional<Record> read(const std::string& line) {
    try {
        return Json::parse(line).get<Record>();
    } catch (const Json::exception&) {
        return {};
    } catch (const std::invalid_argument&) {
        return {};
    }
}

std::string line_of(const Record& record) {
    return Json(record).dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace

std::string record_file_name(const std::string& experiment) {
    std::string name;
    for (const char c : experiment) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-')
            name += c;
        else if (!name.empty() && name.back() != '_')
            name += '_';
    }
    return name + ".jsonl";
}

RecordStore::RecordStore(std::filesystem::path directory, std::string fingerprint)
    : directory_(std::move(directory)), fingerprint_(std::move(fingerprint)) {}

std::filesystem::path RecordStore::path_of(const std::string& experiment) const {
    return directory_ / record_file_name(experiment);
}

RecordStore::File& RecordStore::file_of(const std::string& experiment) {
    const auto [at, is_new] = files_.try_emplace(experiment);
    File& file = at->second;
    if (!is_new) return file;
    std::ifstream in(path_of(experiment));
    for (std::string line; std::getline(in, line);) {
        // A line without its end was torn, even if what is there happens to be understood.
        auto record = in.eof() ? std::nullopt : read(line);
        if (!record || record->experiment != experiment || record->fingerprint != fingerprint_)
            file.is_clean = false;
        if (record && record->experiment == experiment) file.records.push_back(std::move(*record));
    }
    return file;
}

std::optional<Record> RecordStore::newest(const std::string& experiment, const Setting& setting) {
    const std::scoped_lock lock(mutex_);
    const auto& records = file_of(experiment).records;
    const auto at = std::find_if(records.rbegin(), records.rend(),
                                 [&](const Record& r) { return r.setting == setting; });
    return at == records.rend() ? std::nullopt : std::optional(*at);
}

std::optional<Record> RecordStore::newest(const std::string& experiment) {
    const std::scoped_lock lock(mutex_);
    const auto& records = file_of(experiment).records;
    return records.empty() ? std::nullopt : std::optional(records.back());
}

void RecordStore::forget(const std::string& experiment) {
    const std::scoped_lock lock(mutex_);
    files_.erase(experiment);
    std::filesystem::remove(path_of(experiment));
}

std::optional<Record> RecordStore::find(const std::string& experiment, const Setting& setting) {
    auto record = newest(experiment, setting);
    if (record && record->fingerprint == fingerprint_ && record->ending.is_done()) return record;
    return {};
}

void RecordStore::add(Record record) {
    record.fingerprint = fingerprint_;
    const std::scoped_lock lock(mutex_);
    File& file = file_of(record.experiment);
    const auto path = path_of(record.experiment);
    if (!file.is_clean) {
        std::erase_if(file.records, [&](const Record& r) { return r.fingerprint != fingerprint_; });
        std::string kept;
        for (const Record& r : file.records) kept += line_of(r);
        write_file(path, kept);
        file.is_clean = true;
    }
    std::filesystem::create_directories(directory_);
    std::ofstream out(path, std::ios::app | std::ios::binary);
    out << line_of(record) << std::flush;
    if (!out) throw InputError("cannot write " + path.string());
    file.records.push_back(std::move(record));
}

}  // namespace crawford::reports
