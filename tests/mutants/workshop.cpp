#include "workshop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "base/process.hpp"

namespace crawford::mutants {

namespace {

namespace fs = std::filesystem;

constexpr int timed_out = 124;  // as `timeout` says it

Finished run_limited(std::vector<std::string> command, double limit) {
    command.insert(command.begin(),
                   {"timeout", "--foreground", "--kill-after=10", fmt::format("{:.0f}", limit)});
    return run_program(command);
}

/// "study: quantity, norm"
std::string name_of(const nlohmann::json& gate) {
    std::string name = gate.at("study").get<std::string>() + ": ";
    name += gate.at("quantity").get<std::string>();
    if (const auto norm = gate.at("norm").get<std::string>(); !norm.empty()) name += ", " + norm;
    return name;
}

/// The gates that fell short, from what `crawford verify` leaves.
std::vector<std::string> fallen_gates(const fs::path& report) {
    std::vector<std::string> gates;
    std::ifstream in(report);
    if (!in) return gates;
    const auto document = nlohmann::json::parse(in);
    for (const auto& gate : document.at("gates"))
        if (!gate.at("passed").get<bool>()) gates.push_back(name_of(gate));
    return gates;
}

/// The tests that failed, from what GoogleTest says: "[  FAILED  ] Suite.Test (3 ms)".
std::vector<std::string> failed_tests(const std::string& output) {
    constexpr std::string_view mark = "[  FAILED  ] ";
    std::vector<std::string> tests;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(mark)) continue;
        std::string test = line.substr(mark.size());
        test = test.substr(0, test.find_first_of(" ,"));
        if (test.find('.') != std::string::npos && std::ranges::find(tests, test) == tests.end())
            tests.push_back(std::move(test));
    }
    return tests;
}

/// How a program ended that did not pass and names no gate.
std::string end_of(int status, double limit) {
    if (status == timed_out) return fmt::format("no end within {:.0f} s", limit);
    if (status > 128) return fmt::format("killed by signal {}", status - 128);
    return fmt::format("exit code {}", status);
}

}  // namespace

Workshop::Workshop(fs::path tree, fs::path work, int jobs)
    : tree_(std::move(tree)), work_(std::move(work)), build_(work_ / "build"), jobs_(jobs) {
    const auto configured = run_program({"cmake", "-S", tree_.string(), "-B", build_.string(), "-G",
                                         "Ninja", "-DCMAKE_BUILD_TYPE=Release"});
    if (configured.status != 0) throw std::runtime_error(configured.output);
}

std::string Workshop::build(const Judge& judge) const {
    const std::string target = judge.kind == Judge::Kind::study ? "crawford" : "unit_tests";
    const auto built = run_program({"cmake", "--build", build_.string(), "--target", target,
                                    "--parallel", std::to_string(jobs_)});
    return built.status == 0 ? "" : built.output;
}

Finding Workshop::ask(const Judge& judge, double limit) const {
    const auto start = std::chrono::steady_clock::now();
    Finding finding = judge.kind == Judge::Kind::study ? ask_study(judge.name, limit)
                                                       : ask_tests(judge.name, limit);
    finding.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return finding;
}

Finding Workshop::ask_study(const std::string& study, double limit) const {
    const fs::path out = work_ / "out" / study;
    fs::remove_all(out);
    const auto ended = run_limited(
        {(build_ / "crawford").string(), "verify", study, "--quiet", "--out", out.string()}, limit);
    if (ended.status == 0) return {};
    Finding finding{.gates = fallen_gates(out / "verify.json")};
    if (finding.gates.empty())
        finding.gates.push_back(fmt::format("{}: {}", study, end_of(ended.status, limit)));
    return finding;
}

Finding Workshop::ask_tests(const std::string& filter, double limit) const {
    const auto ended = run_limited(
        {(build_ / "tests" / "unit_tests").string(), "--gtest_brief=1", "--gtest_filter=" + filter},
        limit);
    if (ended.output.find("] 0 tests ") != std::string::npos)
        return {.gates = {"unit_tests: no test is called " + filter}};
    if (ended.status == 0) return {};
    Finding finding{.gates = failed_tests(ended.output)};
    if (finding.gates.empty())
        finding.gates.push_back(fmt::format("unit_tests: {}", end_of(ended.status, limit)));
    return finding;
}

}  // namespace crawford::mutants
