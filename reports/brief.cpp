#include "reports/brief.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "reports/judgement.hpp"

namespace crawford::reports {
namespace {

constexpr std::size_t name_width = 48;

std::vector<GateResult> gates_of(const Verification& v, const std::string& study) {
    std::vector<GateResult> gates;
    std::ranges::copy_if(v.gates, std::back_inserter(gates),
                         [&](const GateResult& gate) { return gate.study == study; });
    return gates;
}

std::string words(const Count& count) {
    if (count.all() == 0) return "not run";
    if (count.failed > 0) return fmt::format("{} FAIL", count.failed);
    return word(mark(count));
}

std::string line_of(const StudyRecord& study, const Count& count) {
    const std::string gap = study.name.size() > name_width
                                ? '\n' + std::string(name_width, ' ')
                                : std::string(name_width - study.name.size(), ' ');
    const auto passed = fmt::format("{}/{}", count.passed, count.all());
    return fmt::format("{}{} {:>7}  {:<9} {:>6.1f} CPU s\n", study.name, gap, passed, words(count),
                       study.seconds);
}

}  // namespace

std::string brief(const Verification& v) {
    std::string lines;
    for (const StudyRecord& study : v.studies)
        lines += line_of(study, count(gates_of(v, study.name)));
    std::vector<GateResult> short_of;
    std::ranges::copy_if(v.gates, std::back_inserter(short_of), &GateResult::fell_short);
    return short_of.empty() ? lines : lines + '\n' + table(short_of);
}

}  // namespace crawford::reports
