#include "program/read_tables.hpp"

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/process.hpp"
#include "base/scratch.hpp"
#include "program/points.hpp"

namespace crawford {

namespace {

/// What the child said, without the program's name.
std::string problem_in(const Finished& child) {
    constexpr int killed = 128;
    if (child.status >= killed)
        return fmt::format("the reader ended by signal {}: the file is broken",
                           child.status - killed);
    const std::string prefix = "crawford: ";
    std::string line = child.output.substr(0, child.output.find('\n'));
    return line.starts_with(prefix) ? line.substr(prefix.size()) : line;
}

CsvTable read_mesh(const std::filesystem::path& file, const char* at,
                   const std::filesystem::path& directory) {
    const auto csv = directory / (std::string(at) + ".csv");
    const Finished child =
        run_program({"/proc/self/exe", "points", file.string(), "--at", at, "--out", csv.string()});
    if (child.status != 0) throw InputError(problem_in(child));
    CsvTable table = read_csv(csv);
    table.file = file;
    return table;
}

}  // namespace

std::vector<CsvTable> read_tables(const std::filesystem::path& file) {
    if (!is_mesh_file(file)) return {read_csv(file)};
    const Scratch scratch;
    std::vector<CsvTable> tables;
    for (const char* at : {"points", "cells"}) {
        CsvTable table = read_mesh(file, at, scratch.path());
        if (!table.rows.empty()) tables.push_back(std::move(table));
    }
    if (tables.empty()) throw InputError(file.string() + ": it has no cells");
    return tables;
}

}  // namespace crawford
