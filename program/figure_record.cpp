#include "program/figure_record.hpp"

#include <algorithm>

#include "base/atomic_file.hpp"
#include "base/build_info.hpp"
#include "solver/scene/write_scene.hpp"

namespace crawford {

namespace {

namespace fs = std::filesystem;

constexpr auto fidelity_axis = "fidelity";

std::vector<std::string> names(const std::vector<fs::path>& files) {
    std::vector<std::string> names;
    for (const auto& file : files) names.push_back(file.generic_string());
    return names;
}

}  // namespace

reports::RecordStore figure_records(const fs::path& out) {
    return {out / "records", source_fingerprint()};
}

reports::Setting at_fidelity(const std::string& fidelity) {
    return reports::Setting().set(fidelity_axis, fidelity);
}

std::string drawn_at(const reports::Record& record) {
    for (const auto& [axis, value] : record.setting.axes())
        if (const auto* const word = std::get_if<std::string>(&value);
            word && axis == fidelity_axis)
            return *word;
    return {};  // a record that says something else there
}

std::optional<reports::Record> drawn_record(reports::RecordStore& store, const std::string& name) {
    auto record = store.newest(name);
    if (record && record->ending.is_done() && record->found && record->figure) return record;
    return {};
}

std::vector<Finding> findings_of(const reports::Record& record) {
    std::vector<Finding> findings;
    for (const auto& [what, amount] : record.found->values())
        findings.push_back({what, amount.value, amount.unit});
    return findings;
}

void fill(reports::Record& record, const Outcome& outcome) {
    record.found = reports::Measurement();
    for (const Finding& finding : outcome.findings)
        record.found->value(finding.what, reports::Amount{finding.value, finding.unit});
    for (const Scene& scene : outcome.scenes) record.scenes.push_back(to_toml(scene));
    record.figure = outcome.figure.contents();
}

fs::path manifest_of(const fs::path& figures, const std::string& name) {
    return figures / (name + "_manifest.json");
}

std::vector<fs::path> missing_data(const reports::Record& record, const fs::path& figures) {
    std::vector<fs::path> missing;
    for (const fs::path& file : record.figure->data())
        if (!fs::exists(figures / file)) missing.push_back(figures / file);
    return missing;
}

bool has_all_files(const reports::Record& record, const fs::path& figures) {
    const auto exists = [&](const fs::path& file) { return fs::exists(figures / file); };
    return missing_data(record, figures).empty() &&
           std::ranges::all_of(record.figure->pictures(), exists) &&
           fs::exists(manifest_of(figures, record.experiment));
}

void write_manifest(const fs::path& figures, const reports::Record& record,
                    nlohmann::ordered_json provenance) {
    auto& json = provenance;
    json["source_fingerprint"] = record.fingerprint;
    json["case"] = record.experiment;
    json["fidelity"] = drawn_at(record);
    json["wall_seconds"] = record.cost.wall_seconds;
    auto& findings = json["findings"] = nlohmann::ordered_json::array();
    for (const Finding& f : findings_of(record))
        findings.push_back({{"what", f.what}, {"value", f.value}, {"unit", f.unit}});
    json["pictures"] = names(record.figure->pictures());
    json["data"] = names(record.figure->data());
    json["scenes"] = record.scenes;
    write_file(manifest_of(figures, record.experiment),
               json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
}

}  // namespace crawford
