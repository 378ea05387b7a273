/// The ledger: what the paper claims beside what is found here, and what that rests on. Its
/// document is ledger.json; its page is reports/page/ledger.hpp.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace crawford::reports {

enum class Standing {
    reproduced,     ///< Under the readings that Crawford takes
    other_reading,  ///< Under another reading, which the row names
    not_reproduced  ///< Under none that was tried; the row says why
};

/// "reproduced", "reproduced under another reading", "not reproduced".
std::string_view name(Standing standing);

/// Half widths of the interval about a number, in its unit. What was not studied is missing, what
/// cannot matter (a closed form has no grid) is zero.
struct Uncertainty {
    std::optional<double> grid = {};   ///< Grid convergence index over x and y
    std::optional<double> step = {};   ///< The same over the time step
    std::optional<double> packs = {};  ///< Two standard deviations from pack to pack

    /// Root of the sum of squares of those that are there; nothing if none is.
    std::optional<double> total() const;
};

struct LedgerRow {
    std::string claim = {};  ///< "mean burn rate of the pack, thermo-mechanical"
    std::string where = {};  ///< "Fig. 15b"
    std::string entry = {};  ///< The case that shows it: "fig15"
    std::string unit = {};   ///< "-" if it has none
    std::string paper = {};  ///< As printed: "0.42", "about 80", "stress is confined to AP"
    std::string ours = {};   ///< As shown: "0.416", or in words
    std::optional<double> paper_value = {};  ///< Where it is a number
    std::optional<double> value = {};        ///< Likewise, ours
    Uncertainty uncertainty = {};
    std::string reading = {};  ///< Under which `ours` was found
    Standing standing = Standing::not_reproduced;
    std::string why = {};  ///< What the verdict rests on, in a sentence or two
};

/// Runs that differ in how the paper is read and in nothing else.
struct ReadingRun {
    std::string reading = {};           ///< "as read", "alpha K", ...
    std::vector<std::string> set = {};  ///< The keys it changes, "dotted.key=value"
    std::vector<double> values = {};    ///< Of ReadingMatrix::quantities; NaN where it failed
    /// Root mean square of (ours - paper)/paper over the quantities that the paper states.
    double distance = 0.0;
    std::string failure = {};  ///< Why it did not end, if so
};

struct Quantity {
    std::string name = {};
    std::string unit = {};
    std::optional<double> paper = {};
};

/// Which reading comes nearest to all that the paper says of one configuration.
struct ReadingMatrix {
    std::string title = {};
    std::string grid = {};  ///< In words
    std::vector<Quantity> quantities = {};
    std::vector<ReadingRun> runs = {};
};

/// One number under refinement in one direction.
struct Refinement {
    std::string quantity = {};   ///< "mean burn rate"
    std::string of = {};         ///< "burning sandwich", "pack"
    std::string direction = {};  ///< "x", "y", "x and y", "dt"
    std::string unit = {};
    std::vector<double> sizes = {};           ///< Cell or step, coarsest first
    std::string size_unit = {};               ///< "um", "us"
    std::vector<double> values = {};          ///< One a size
    double used = 0.0;                        ///< The size that the ledger's number was found with
    std::optional<double> order = {};         ///< Observed
    std::optional<double> extrapolated = {};  ///< Richardson's
    std::optional<double> index = {};  ///< Grid convergence index of the size used, in `unit`
    std::string verdict = {};          ///< "monotone", "oscillating", ...
};

/// One number over several packs of the same discs.
struct Spread {
    std::string quantity = {};
    std::string unit = {};
    std::vector<unsigned long> seeds = {};
    std::vector<double> values = {};  ///< One a seed
    double mean = 0.0;
    double deviation = 0.0;  ///< Sample standard deviation
};

struct Ledger {
    std::string manifest = "{}";  ///< version, revision, fidelity, machine, ...: JSON
    std::vector<LedgerRow> rows;
    std::vector<ReadingMatrix> readings;
    std::vector<Refinement> refinements;
    std::vector<Spread> spreads;
};

/// Writes it as one JSON document, atomically. A number that is missing becomes null, and so does
/// one that is not finite: read back it is missing where it may be, else NaN.
/// \throws InputError naming the file.
void write(const std::filesystem::path& file, const Ledger& ledger);

/// \throws InputError naming the file and what is missing or wrong in it.
Ledger read_ledger(const std::filesystem::path& file);

}  // namespace crawford::reports
