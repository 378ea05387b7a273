/// All that one run of the studies has found: what verify.json holds and the report is made of.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/coverage.hpp"
#include "reports/gate.hpp"

namespace crawford::reports {

/// A study as the report shows it, beside its gates.
struct StudyRecord {
    std::string name = {};
    std::string entry = {};    ///< of the catalogue; several studies may share one
    std::string page = {};     ///< The opening comment of its file, Markdown
    std::string source = {};   ///< That file
    std::string command = {};  ///< Repeats it
    std::vector<std::string> covers = {};
    std::string axis = {};        ///< That it refines: "rows", "steps"
    std::vector<int> grids = {};  ///< Those that were run
    double seconds = 0.0;
};

struct Verification {
    std::string manifest = "{}";  ///< Version, revision, machine, ...: a JSON object as text
    /// All studies on all their grids: then there must be no gap in the coverage.
    bool whole = false;
    std::vector<std::string> terms;  ///< Of the model's equations
    std::vector<StudyRecord> studies;
    std::vector<GateResult> gates;

    /// The terms that the entries of the catalogue cover, each by all its studies.
    Coverage coverage() const;
    /// Whether every gate was judged and has passed, and nothing is uncovered.
    bool passed() const;
    /// Whether a gate has failed, there is none, or something is uncovered.
    bool fell_short() const;
    /// The closing lines: counts, each gate that fell short and each gap, and what that means.
    std::string summary() const;
};

/// Writes it as one JSON document, atomically: the members of the manifest, then "passed", "whole",
/// "terms", "studies", "gates".
/// \throws InputError naming the file.
void write(const std::filesystem::path& file, const Verification& verification);

/// \throws InputError naming the file and what is missing or wrong in it.
Verification read_verification(const std::filesystem::path& file);

/// Only the gates, of a file of this or an earlier version.
/// \throws InputError naming the file, in one line.
std::vector<GateResult> read_gates(const std::filesystem::path& file);

}  // namespace crawford::reports
