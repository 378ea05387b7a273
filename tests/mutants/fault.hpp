/// Seeded faults: changes of one place in the sources, each of which some gate must see.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace crawford::mutants {

/// Something that may see a fault: a study of `crawford verify`, or unit tests.
struct Judge {
    enum class Kind { study, tests } kind = Kind::study;
    std::string name = "";  ///< of the study, or the filter of the tests

    std::string label() const { return kind == Kind::study ? name : "unit_tests " + name; }
    bool operator==(const Judge&) const = default;
};

/// One row of the table.
struct Fault {
    std::string name;
    std::string file;    ///< relative to the root of the sources
    std::string from;    ///< text that stands in the file exactly once
    std::string to;      ///< what takes its place
    std::string breaks;  ///< what goes wrong, in a few words
    Judge seen_by;       ///< who is expected to see it first
};

/// Reads a table of faults, [[fault]] by [[fault]]; its keys are the members' names, and either
/// `study` or `test` says who sees it.
/// \throws std::invalid_argument naming the line, if a key is missing, unknown or no text, if a
/// name stands twice, or if a fault changes nothing.
std::vector<Fault> read_faults(const std::filesystem::path& table);

/// `text` with the fault in it.
/// \throws std::invalid_argument unless fault.from stands in it exactly once.
std::string with_fault(const std::string& text, const Fault& fault);

}  // namespace crawford::mutants
