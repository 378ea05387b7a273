#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "program/commands.hpp"
#include "program/interrupt.hpp"
#include "program/judged_files.hpp"
#include "program/outside_options.hpp"
#include "program/provenance.hpp"
#include "program/told_truth.hpp"
#include "reports/gate_json.hpp"
#include "reports/judgement.hpp"
#include "reports/junit.hpp"
#include "reports/verification.hpp"

namespace crawford {

namespace {

using reports::Gate;
using reports::GateResult;
using reports::Norm;

bool is_mapped(const JudgedFiles& files, const std::string& field) {
    return std::ranges::any_of(files.fields,
                               [&](const MappedField& one) { return one.field.name == field; });
}

/// The gates of the case on the fields that there are, or those that are asked for.
std::vector<Gate> gates_of(const JudgeCase& one, const JudgedFiles& files,
                           const JudgeOptions& options) {
    std::vector<Gate> gates;
    if (options.expect) {
        for (const auto& mapped : files.fields)
            gates.push_back({mapped.field.name, Norm::L2,
                             reports::expect(*options.expect).within(options.within),
                             fmt::format("it was asked for: --expect {:g} --within {:g}",
                                         *options.expect, options.within)});
        return gates;
    }
    for (const Gate& gate : one.gates)
        if (is_mapped(files, gate.quantity)) gates.push_back(gate);
    return gates;
}

/// A study whose runs are the files: judged as ours are.
std::vector<GateResult> judged(const JudgeCase& one, const JudgedFiles& files,
                               const JudgeOptions& options) {
    std::vector<int> grids;
    for (const auto& run : files.runs) grids.push_back(run.grid);
    reports::Study study(one.name);
    study.refines("grid", grids);
    for (const Gate& gate : gates_of(one, files, options))
        study.gate(gate.quantity, gate.norm, gate.expected, gate.reason);
    if (!options.expect)
        for (const FieldBound& bound : one.bounds)
            if (is_mapped(files, bound.field))
                study.bound("|" + bound.field + " - truth|, largest", grids.back(),
                            reports::at_most(bound.most), bound.reason);
    return judge_rows(study, files.runs);
}

/// Errors and orders of what no gate asks for.
std::vector<GateResult> ungated(const JudgeCase& one, const JudgedFiles& files,
                                const std::vector<GateResult>& gated) {
    std::vector<GateResult> results;
    for (const auto& mapped : files.fields)
        for (const Norm norm : {Norm::L1, Norm::L2, Norm::Linf}) {
            const auto& field = mapped.field.name;
            if (std::ranges::any_of(gated, [&](const GateResult& r) {
                    return r.quantity == field && r.norm == name(norm);
                }))
                continue;
            reports::Study study(one.name);
            std::vector<int> grids;
            for (const auto& run : files.runs) grids.push_back(run.grid);
            study.refines("grid", grids).gate(field, norm, reports::expect(2.0), "told, not gated");
            for (GateResult result : judge_rows(study, files.runs)) {
                result.gated = result.passed = false;
                result.failure.clear();
                result.expected = result.below = result.above = reports::not_applicable;
                results.push_back(std::move(result));
            }
        }
    return results;
}

std::string told(const std::vector<GateResult>& gated, const std::vector<GateResult>& others) {
    auto text = reports::table(gated);
    if (!others.empty()) text += "\nNot gated:\n";
    for (const GateResult& r : others) {
        text += fmt::format("  {}, {}:", r.quantity, r.norm);
        for (std::size_t k = 0; k < r.errors.size(); ++k)
            text += fmt::format("{} {:.3e} on {}", k == 0 ? "" : ",", r.errors[k], r.grids[k]);
        text += r.errors.size() > 1 ? fmt::format("; order {:.3f}, {}\n", r.fit, r.verdict) : "\n";
    }
    return text;
}

std::string as_json(const JudgeCase& one, const JudgeOptions& options,
                    const std::vector<GateResult>& gated, const std::vector<GateResult>& others) {
    using Json = nlohmann::ordered_json;
    Json json{{"case", one.name},
              {"truth", one.truth},
              {"set", options.set},
              {"time", options.time},
              {"from_surface", options.from_surface},
              {"passed", gated.empty() ? Json(nullptr) : Json(reports::all_passed(gated))},
              {"gates", gated},
              {"not_gated", others}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// As it can be typed again, from the root of the tree.
std::string command_of(CommandLine command) {
    command.front() = "build/crawford";
    return typed(command);
}

reports::Verification verification(const JudgeCase& one, const JudgedFiles& files,
                                   const std::vector<GateResult>& gated,
                                   const std::vector<std::string>& command) {
    reports::Verification found;
    std::vector<int> grids;
    for (const auto& run : files.runs) grids.push_back(run.grid);
    found.studies.push_back(
        {.name = one.name,
         .entry = one.name,
         .page = fmt::format("# {}: results of another code\n\n{}", one.name, one.task),
         .command = command_of(command),
         .axis = "grid",
         .grids = grids});
    found.gates = gated;
    found.manifest =
        provenance(command).dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    return found;
}

void write_results(const JudgeOptions& options, const reports::Verification& found) {
    if (options.junit) reports::write_junit(*options.junit, found);
    if (!options.out) return;
    prepare_directory(*options.out);
    reports::write(*options.out / "verify.json", found);
    report({.out = *options.out});
}

int describe(const JudgeCase& one, const JudgeOptions& options) {
    const std::string text = options.json ? described_as_json(one) : described(one);
    if (options.json && !options.json->empty() && *options.json != "-")
        write_file(*options.json, text);
    else
        std::cout << text;
    return exit_code::done;
}

void check(const JudgeOptions& options) {
    if (options.json && options.json->string().find('=') != std::string::npos)
        throw InputError(fmt::format(
            "--json {}: name a file, or - for standard output, before the next argument",
            options.json->string()));
    if (options.expect && !(*options.expect > 0.0))
        throw InputError(fmt::format("--expect {} must be above 0", *options.expect));
    if (!(options.within > 0.0))
        throw InputError(fmt::format("--within {} must be above 0", options.within));
}

}  // namespace

int judge(const JudgeOptions& options, const std::vector<std::string>& command) {
    check(options);
    JudgeCase one = judge_case(options.name);
    if (options.describe) return describe(one, options);
    one.set.insert(one.set.end(), options.set.begin(), options.set.end());
    const auto truth = told_truth(one.entry(), one.set);
    const WherePoints where{.time = options.time.empty() ? 0.0 : told_time(options.time),
                            .from_surface = options.from_surface};
    const JudgedFiles files = judged_files(one, truth, options.files, options.fields, where);
    const auto gated = judged(one, files, options);
    const auto others = ungated(one, files, gated);
    const bool only_json = options.json && (options.json->empty() || *options.json == "-");
    write_results(options, verification(one, files, gated, command));
    const std::string json = as_json(one, options, gated, others);
    std::cout << (only_json ? json : told(gated, others));
    if (options.json && !only_json) write_file(*options.json, json);
    const bool fell_short = std::ranges::any_of(gated, &GateResult::fell_short);
    return fell_short ? exit_code::gate_fell_short : exit_code::done;
}

}  // namespace crawford
