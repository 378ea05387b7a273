/// Another code's results, a file a grid, as measurements.
#pragma once

#include <string>
#include <vector>

#include "program/judge_case.hpp"
#include "reports/judge_rows.hpp"

namespace crawford {

/// A field of the truth and where the files have it.
struct MappedField {
    reference::Field field;
    std::string column;
    std::string unit;  ///< where the heading has none, or another
};

/// Which points the files hold.
struct WherePoints {
    double time = 0.0;          ///< [s]
    bool from_surface = false;  ///< y counts from the highest point of each file
};

struct JudgedFiles {
    std::vector<MappedField> fields;
    std::vector<reports::GridRun> runs;  ///< coarsest first
};

/// Reads "GRID=FILE" (\see read_tables) and compares each with the truth, point by point; a column "weight" or "area"
/// weighs the points. `fields` are "NAME=COLUMN[:UNIT]"; without them every column that bears the
/// name of a field.
/// \throws InputError naming grid, file, line or field.
JudgedFiles judged_files(const JudgeCase& one, const reference::Truth& truth,
                         const std::vector<std::string>& files,
                         const std::vector<std::string>& fields, const WherePoints& where);

}  // namespace crawford
