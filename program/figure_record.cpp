#include "program/figure_record.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "base/atomic_file.hpp"
#include "base/build_info.hpp"

namespace crawford {

namespace {

namespace fs = std::filesystem;

fs::path file_of(const fs::path& directory, const std::string& name) {
    return directory / (name + "_manifest.json");
}

std::vector<std::string> names(const std::vector<fs::path>& files) {
    std::vector<std::string> names;
    for (const auto& file : files) names.push_back(file.filename().string());
    return names;
}

std::vector<fs::path> files(const nlohmann::json& names, const fs::path& directory) {
    std::vector<fs::path> files;
    for (const auto& name : names) files.push_back(directory / name.get<std::string>());
    return files;
}

}  // namespace

bool FigureRecord::is_of(const std::string& wanted_fidelity) const {
    const auto exists = [](const fs::path& file) { return fs::exists(file); };
    return fidelity == wanted_fidelity && sources == source_fingerprint() &&
           std::ranges::all_of(pictures, exists) && std::ranges::all_of(data, exists);
}

void write(const fs::path& directory, const std::string& name, const FigureRecord& record,
           nlohmann::ordered_json provenance) {
    auto& json = provenance;
    json["source_fingerprint"] = source_fingerprint();
    json["case"] = name;
    json["fidelity"] = record.fidelity;
    json["wall_seconds"] = record.seconds;
    auto& findings = json["findings"] = nlohmann::ordered_json::array();
    for (const Finding& f : record.findings)
        findings.push_back({{"what", f.what}, {"value", f.value}, {"unit", f.unit}});
    json["pictures"] = names(record.pictures);
    json["data"] = names(record.data);
    json["scenes"] = record.scenes;
    write_file(file_of(directory, name), json.dump(2) + '\n');
}

std::optional<FigureRecord> read_figure_record(const fs::path& directory, const std::string& name) {
    std::ifstream file(file_of(directory, name));
    const auto json = nlohmann::json::parse(file, nullptr, false);
    try {
        FigureRecord record{.fidelity = json.at("fidelity"),
                            .seconds = json.at("wall_seconds"),
                            .pictures = files(json.at("pictures"), directory),
                            .data = files(json.at("data"), directory),
                            .scenes = json.at("scenes"),
                            .sources = json.at("source_fingerprint")};
        for (const auto& f : json.at("findings")) {
            const auto& value = f.at("value");  // null where it is not a number
            record.findings.push_back(
                {f.at("what"), value.is_null() ? std::nan("") : value.get<double>(), f.at("unit")});
        }
        return record;
    } catch (const nlohmann::json::exception&) {
        return {};
    }
}

}  // namespace crawford
