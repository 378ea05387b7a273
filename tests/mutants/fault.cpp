#include "fault.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

namespace crawford::mutants {

namespace {

constexpr std::array<std::string_view, 7> keys{"name",   "file",  "from", "to",
                                               "breaks", "study", "test"};

[[noreturn]] void refuse(const toml::node& where, const std::string& why) {
    throw std::invalid_argument(
        fmt::format("table of faults, line {}: {}", where.source().begin.line, why));
}

std::string text_of(const toml::table& row, std::string_view key) {
    const auto value = row[key].value<std::string>();
    if (!value) refuse(row, fmt::format("{} is missing, or no text", key));
    return *value;
}

Judge judge_of(const toml::table& row) {
    if (row.contains("study") == row.contains("test"))
        refuse(row, "needs one of study and test, to say who sees it");
    if (row.contains("study")) return {Judge::Kind::study, text_of(row, "study")};
    return {Judge::Kind::tests, text_of(row, "test")};
}

Fault fault_of(const toml::table& row) {
    for (const auto& [key, value] : row)
        if (std::ranges::find(keys, key.str()) == keys.end())
            refuse(value, fmt::format("unknown key {}", key.str()));
    Fault fault{text_of(row, "name"), text_of(row, "file"),   text_of(row, "from"),
                text_of(row, "to"),   text_of(row, "breaks"), judge_of(row)};
    if (fault.from.empty() || fault.from == fault.to) refuse(row, "changes nothing");
    return fault;
}

}  // namespace

std::vector<Fault> read_faults(const std::filesystem::path& table) {
    std::vector<Fault> faults;
    try {
        const toml::table root = toml::parse_file(table.string());
        const toml::array* rows = root["fault"].as_array();
        if (!rows || root.size() != 1) refuse(root, "holds [[fault]] and nothing else");
        for (const toml::node& node : *rows) {
            if (!node.is_table()) refuse(node, "a fault is a table");
            Fault fault = fault_of(*node.as_table());
            if (std::ranges::find(faults, fault.name, &Fault::name) != faults.end())
                refuse(node, fault.name + " stands twice");
            faults.push_back(std::move(fault));
        }
    } catch (const toml::parse_error& error) {
        throw std::invalid_argument(fmt::format("table of faults, line {}: {}",
                                                error.source().begin.line, error.description()));
    }
    return faults;
}

std::string with_fault(const std::string& text, const Fault& fault) {
    const auto first = text.find(fault.from);
    if (first == std::string::npos)
        throw std::invalid_argument(
            fmt::format("{}: its text does not stand in {}", fault.name, fault.file));
    if (text.find(fault.from, first + 1) != std::string::npos)
        throw std::invalid_argument(
            fmt::format("{}: its text stands more than once in {}", fault.name, fault.file));
    return std::string(text).replace(first, fault.from.size(), fault.to);
}

}  // namespace crawford::mutants
