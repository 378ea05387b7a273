#include "ledger.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/atomic_file.hpp"

namespace crawford::mutants {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Finding, gates, seconds)

Ledger::Ledger(std::filesystem::path file) : file_(std::move(file)) {
    std::ifstream in(file_);
    if (!in) return;
    try {
        nlohmann::json::parse(in).get_to(findings_);
    } catch (const nlohmann::json::exception& problem) {
        throw std::runtime_error(file_.string() +
                                 " is no ledger of findings, remove it: " + problem.what());
    }
}

std::optional<Finding> Ledger::find(const std::string& key) const {
    const auto at = findings_.find(key);
    if (at == findings_.end()) return {};
    return at->second;
}

void Ledger::keep(const std::string& key, const Finding& finding) {
    findings_[key] = finding;
    write_file(file_, nlohmann::json(findings_).dump(1) + '\n');
}

}  // namespace crawford::mutants
