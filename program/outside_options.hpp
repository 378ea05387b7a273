/// Commands for the results of other codes: order, truth, judge. Exit codes as in commands.hpp.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace crawford {

struct OrderOptions {
    std::filesystem::path table;
    int dimension = 1;
    std::vector<std::string> quantities;  ///< all if empty
    std::optional<double> expect;
    double within = 0.1;
    std::optional<double> from, to;  ///< coarsest and finest, as in the first column
    std::optional<double> scatter;
    double size = 1.0;                           ///< of the truth of errors
    std::optional<std::filesystem::path> json;   ///< "-": stdout, and nothing else there
    std::optional<std::filesystem::path> plot;   ///< SVG
    std::optional<std::filesystem::path> junit;  ///< needs `expect`
};

struct TruthOptions {
    std::string name;
    bool help = false;  ///< what to type; with a name, as `describe`
    bool list = false;
    bool describe = false;  ///< parameters and fields, instead of values
    std::filesystem::path points;
    std::vector<std::string> set;  ///< "key=value"
    std::string time;              ///< with its unit; 0 s if empty
};

struct JudgeOptions {
    std::string name;                 ///< of a case
    std::vector<std::string> files;   ///< "GRID=FILE"
    std::vector<std::string> fields;  ///< "NAME=COLUMN" or "NAME=COLUMN:UNIT"
    std::vector<std::string> set;     ///< "key=value"
    std::string time;                 ///< with its unit; 0 s if empty
    bool from_surface = false;        ///< y counts from the highest point
    std::optional<double> expect;     ///< in place of the gates of the case
    double within = 0.1;
    bool describe = false;
    std::optional<std::filesystem::path> json;   ///< "-": stdout, and nothing else there
    std::optional<std::filesystem::path> junit;  ///< JUnit XML, a test a gate
    std::optional<std::filesystem::path> out;    ///< directory for verify.json and report.html
};

/// Reads orders and uncertainties from a table and holds them against what is expected.
/// \throws InputError if the table cannot be used.
int order(const OrderOptions& options);

/// Prints what an exact solution of the registry is at points, as CSV; or what there is to ask.
/// \throws InputError for an unknown truth or parameter, one out of its limits, a point outside.
int truth(const TruthOptions& options);

/// Holds the results of another code on several grids against an exact solution; or says what
/// there is to solve.
/// \throws InputError \see truth; if a file cannot be used.
int judge(const JudgeOptions& options, const std::vector<std::string>& command);

}  // namespace crawford
