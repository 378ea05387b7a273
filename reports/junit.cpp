#include "reports/junit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/property_tree/xml_parser.hpp>
#include <sstream>

#include "base/atomic_file.hpp"
#include "reports/judgement.hpp"

namespace crawford::reports {
namespace {

using Element = boost::property_tree::ptree;

/// XML 1.0 has no way to write the other control characters.
std::string legal(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t'; },
        '?');
    return text;
}

void set(Element& element, const std::string& attribute, const std::string& value) {
    element.put("<xmlattr>." + attribute, legal(value));
}

Element test(const std::string& suite, const std::string& name, double seconds) {
    Element element;
    set(element, "classname", suite);
    set(element, "name", name);
    set(element, "time", fmt::format("{:.3f}", seconds));
    return element;
}

Element failure(const std::string& message, const std::string& text) {
    Element element(legal(text));
    set(element, "message", message);
    return element;
}

Element skipped(const std::string& message) {
    Element element;
    set(element, "message", message);
    return element;
}

/// Of a gate of order with its grids: one quantity may be gated on several ranges of them.
std::string name_of(const GateResult& gate) {
    if (gate.kind == GateKind::bound) return gate.quantity;
    return fmt::format("{}, {}, grids {} to {}, order {:g}", gate.quantity, gate.norm,
                       gate.coarsest, gate.finest, gate.expected);
}

Element test_of(const GateResult& gate) {
    auto element = test(gate.study, name_of(gate), gate.seconds);
    if (gate.fell_short())
        element.add_child("failure", failure(gate.failure, table({gate})));
    else if (!gate.gated)
        element.add_child("skipped", skipped(gate.failure));
    return element;
}

Element suite(const std::string& name, const Count& count, double seconds) {
    Element element;
    set(element, "name", name);
    set(element, "tests", fmt::format("{}", count.all()));
    set(element, "failures", fmt::format("{}", count.failed));
    set(element, "errors", "0");
    set(element, "skipped", fmt::format("{}", count.not_gated));
    set(element, "time", fmt::format("{:.3f}", seconds));
    return element;
}

Element suite_of(const StudyRecord& study, const std::vector<GateResult>& all) {
    std::vector<GateResult> gates;
    for (const GateResult& gate : all)
        if (gate.study == study.name) gates.push_back(gate);
    auto element = suite(study.name, count(gates), study.seconds);
    for (const GateResult& gate : gates) element.add_child("testcase", test_of(gate));
    return element;
}

Element suite_of_gaps(const std::vector<std::string>& gaps) {
    auto element = suite("coverage", {.passed = 0, .failed = gaps.size(), .not_gated = 0}, 0.0);
    for (const std::string& gap : gaps) {
        auto uncovered = test("coverage", gap, 0.0);
        uncovered.add_child("failure", failure(gap, gap));
        element.add_child("testcase", uncovered);
    }
    return element;
}

}  // namespace

void write_junit(const std::filesystem::path& file, const Verification& v) {
    Element suites;
    for (const StudyRecord& study : v.studies)
        suites.add_child("testsuite", suite_of(study, v.gates));
    if (v.whole) suites.add_child("testsuite", suite_of_gaps(v.coverage().gaps()));
    Element document;
    document.add_child("testsuites", suites);
    std::ostringstream text;
    boost::property_tree::write_xml(text, document);
    write_file(file, text.str() + '\n');
}

}  // namespace crawford::reports
