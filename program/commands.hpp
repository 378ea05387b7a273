/// The commands of `crawford`. Each returns the exit code; what goes wrong is an exception, which
/// main() turns into one line and a code.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cases/registry.hpp"

namespace crawford {

namespace exit_code {
inline constexpr int done = 0;
inline constexpr int gate_fell_short = 1;
inline constexpr int wrong_input = 2;
inline constexpr int numbers_failed = 3;
}  // namespace exit_code

using CommandLine = std::vector<std::string>;  ///< as typed, for manifests

struct RunOptions {
    std::vector<std::string> cases;
    bool all = false;  ///< every case, whatever is named
    std::string fidelity = "paper";
    std::filesystem::path out = "out";
    bool again = false;               ///< draw also what is up to date
    bool movie = false;               ///< the movies of the cases
    std::optional<unsigned> threads;  ///< runs side by side; one a core if none is given
    bool from_records =
        false;  ///< draw again what has been drawn, whatever fidelity if it is empty
    bool quiet = false;
};

struct LedgerOptions {
    std::optional<unsigned> threads;   ///< as run
    bool settle = false;               ///< burn all that it rests on; else take the one in the tree
    std::vector<std::string> figures;  ///< settle only the claims of these cases; all if empty
    std::string fidelity = "paper";
    std::filesystem::path out = "out";
    bool quiet = false;
};

struct VerifyOptions {
    std::vector<std::string> studies;  ///< all if empty
    std::vector<int> grids;            ///< each study's own if empty; see help.hpp
    std::string axis;                  ///< "rows=32,64": as grids, of the studies that refine it
    bool judge_only = false;           ///< run nothing, judge the records that are there
    std::optional<std::filesystem::path> against;  ///< an earlier verify.json
    std::optional<double> grown;                   ///< factor >= 1, of what is listed against it
    bool exact = false;                            ///< against it, bit by bit
    std::optional<unsigned> threads;               ///< as run
    bool verbose = false;                          ///< print every gate in full
    std::optional<std::filesystem::path> junit;    ///< JUnit XML to write
    std::filesystem::path out = "out/verify";
    bool quiet = false;
};

struct ReportOptions {
    std::filesystem::path out = "out";
};

struct BurnSceneOptions {
    std::filesystem::path scene;
    std::vector<std::string> set;  ///< "dotted.key=value"
    std::filesystem::path out;     ///< out/<name of the scene> if empty
    std::optional<std::filesystem::path> restart;
    bool resume = false;   ///< from what an earlier run has left in the folder, whatever that is
    std::string preset;    ///< a name; empty if none is asked for
    std::string accuracy;  ///< of V, "1 %"; empty likewise
    bool timing = false;
    bool as_written = false;  ///< nothing is left out
    bool check = false;       ///< only what its numbers will be
    bool json = false;        ///< those, or how it ended, as JSON
    bool quiet = false;
};

struct PackOptions {
    std::filesystem::path scene;
    std::vector<std::string> set;  ///< "dotted.key=value"
    std::filesystem::path out;     ///< out/<name of the scene>.csv if empty
};

struct ListOptions {
    bool studies = false;  ///< only these, as "name seconds" lines for programs
};

/// The catalogue, on stdout.
int list(const ListOptions& options);

/// Draws cases that are not up to date, or from_records again what they have left, as many at a
/// time as there are cores, and goes on with burns that were cut off. One that fails stops no
/// other.
/// \throws InputError naming the nearest case if one is unknown or has no record, before anything
/// is computed.
int run(const RunOptions& options, const CommandLine& command);

/// The same amid another command, which watches for signals itself.
int draw_cases(const RunOptions& options, const CommandLine& command);

/// Writes DIR/figures/ledger.json and its page: settled anew, or as it lies in the source tree. Of
/// some figures only, DIR/figures/ledger-FIGURE....json.
/// \throws InputError naming the nearest case if a figure is unknown or shows no claim.
/// \throws NumericalFailure if a case that it cites or a burn that a row rests on fails.
int settle_ledger(const LedgerOptions& options, const CommandLine& command);

/// Runs studies, all their grids out of one queue, and writes verify.json and report.html.
/// \throws InputError as run(), or if no study has any of the grids.
int verify(const VerifyOptions& options, const CommandLine& command);

/// Writes the pages anew from the results that are there: see help.hpp.
/// \throws InputError if there are none or they cannot be understood.
int report(const ReportOptions& options);

/// Burns a scene, or only checks it: prints its numbers, their limits and what they will do.
/// \throws InputError if the scene is wrong or its numbers are refused; a check prints them first.
int burn(const BurnSceneOptions& options, const CommandLine& command);

/// Writes the discs of a scene as CSV.
/// \throws InputError if the scene is wrong or has none.
int pack(const PackOptions& options);

}  // namespace crawford
