/// What other codes may be judged on: problems with an exact solution, and what to expect of them.
#pragma once

#include <string>
#include <vector>

#include "reference/truth_registry.hpp"
#include "reports/gate.hpp"

namespace crawford {

/// The largest error of a field on the finest grid.
struct FieldBound {
    std::string field;
    double most;  ///< SI
    std::string reason;
};

struct JudgeCase {
    std::string name;
    std::string truth;             ///< of the registry
    std::string task;              ///< what to solve: equations, geometry, conditions
    std::vector<std::string> set;  ///< parameters of the truth, "key=value"
    std::vector<reports::Gate> gates;
    std::vector<FieldBound> bounds;

    const reference::TruthEntry& entry() const { return reference::find_truth(truth); }
};

/// A case by its name; each truth of the registry is one too, without gates of its own.
/// \throws InputError naming the nearest
JudgeCase judge_case(const std::string& name);

/// For a terminal, and for programs.
std::string described(const JudgeCase& one);
std::string described_as_json(const JudgeCase& one);

}  // namespace crawford
