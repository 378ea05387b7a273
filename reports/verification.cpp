#include "reports/verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "base/json_problem.hpp"
#include "base/whole_number.hpp"
#include "reports/gate_json.hpp"
#include "reports/judgement.hpp"

namespace crawford::reports {
namespace {

using Json = nlohmann::ordered_json;

std::string title(const GateResult& gate) {
    return gate.norm.empty() ? fmt::format("{}: {}", gate.study, gate.quantity)
                             : fmt::format("{}: {}, {}", gate.study, gate.quantity, gate.norm);
}

}  // namespace

void to_json(Json& json, const StudyRecord& s) {
    json = {{"name", s.name},       {"entry", s.entry},     {"source", s.source},
            {"command", s.command}, {"covers", s.covers},   {"axis", s.axis},
            {"grids", s.grids},     {"seconds", s.seconds}, {"page", s.page}};
}

void from_json(const Json& json, StudyRecord& s) {
    json.at("name").get_to(s.name);
    json.at("entry").get_to(s.entry);
    json.at("source").get_to(s.source);
    json.at("command").get_to(s.command);
    json.at("covers").get_to(s.covers);
    s.axis = json.value("axis", "");  // an older report does not say
    s.grids = whole_numbers<int>(json.at("grids"));
    json.at("seconds").get_to(s.seconds);
    json.at("page").get_to(s.page);
}

Coverage Verification::coverage() const {
    std::vector<CoveredBy> covered;
    for (const auto& study : studies) {
        auto at = std::ranges::find(covered, study.entry, &CoveredBy::study);
        if (at == covered.end()) at = covered.insert(at, {study.entry, {}});
        at->terms.insert(at->terms.end(), study.covers.begin(), study.covers.end());
    }
    return {terms, std::move(covered)};
}

bool Verification::passed() const {
    return all_passed(gates) && !fell_short();
}

bool Verification::fell_short() const {
    return gates.empty() || std::ranges::any_of(gates, &GateResult::fell_short) ||
           (whole && !coverage().gaps().empty());
}

std::string Verification::summary() const {
    std::string lines = text(count(gates)) + '\n';
    for (const auto& gate : gates)
        if (gate.fell_short()) lines += fmt::format("FAIL: {}: {}\n", title(gate), gate.failure);
    if (whole)
        for (const auto& gap : coverage().gaps()) lines += fmt::format("FAIL: {}\n", gap);
    if (count(gates).not_gated > 0)
        lines += "this is a quick look and no verification: gates were left without their grids\n";
    return lines;
}

void write(const std::filesystem::path& file, const Verification& v) {
    Json document = Json::parse(v.manifest);
    document["passed"] = v.passed();
    document["whole"] = v.whole;
    document["terms"] = v.terms;
    document["studies"] = v.studies;
    document["gates"] = v.gates;
    write_file(file, document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

Verification read_verification(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in || std::filesystem::is_directory(file))
        throw InputError(fmt::format("{} cannot be read", file.string()));
    try {
        Verification v;
        Json document = Json::parse(in);
        document.at("whole").get_to(v.whole);
        document.at("terms").get_to(v.terms);
        document.at("studies").get_to(v.studies);
        document.at("gates").get_to(v.gates);
        for (const char* key : {"passed", "whole", "terms", "studies", "gates"})
            document.erase(key);
        v.manifest = document.dump();
        return v;
    } catch (const Json::exception& problem) {
        throw InputError(fmt::format("{}: {}", file.string(), json_problem(problem.what())));
    }
}

std::vector<GateResult> read_gates(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in || std::filesystem::is_directory(file))
        throw InputError(fmt::format("{} cannot be read", file.string()));
    try {
        return Json::parse(in).at("gates").get<std::vector<GateResult>>();
    } catch (const Json::exception& problem) {
        throw InputError(fmt::format("{} is no verify.json of crawford: {}", file.string(),
                                     json_problem(problem.what())));
    }
}

}  // namespace crawford::reports
