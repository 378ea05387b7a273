/// The course of a run as one table: `<name>_history.csv`.
#pragma once

#include <filesystem>
#include <fstream>
#include <vector>

namespace crawford {

/// One row.
struct HistoryRow {
    double time;                 ///< [s]
    double mean_burn_rate;       ///< [m/s]
    double largest_temperature;  ///< [K]
    double largest_strain;
    double residual;
    int solver_iterations;
    double strain_about_peak;    ///< mean over peak_radius about the largest; see Peak
    double largest_pressure;     ///< [Pa]
    double pressure_about_peak;  ///< likewise [Pa]
};

/// Rows are appended and flushed one by one: a run that is killed leaves the rows it had reached.
/// Numbers have the digits it takes to read the same double again.
class History {
public:
    /// Starts the file with its header.
    /// \throws InputError if it cannot be written.
    static History start(const std::filesystem::path& path);

    /// Goes on after `time` [s] with the file on disk, or starts one where there is none. Rows
    /// after that time and a last line cut short are dropped, so that the file reads as that of an
    /// unbroken run.
    /// \throws InputError if the file is no history or cannot be written.
    static History resume(const std::filesystem::path& path, double time);

    /// \throws InputError if the row cannot be written.
    void append(const HistoryRow& row);

private:
    explicit History(const std::filesystem::path& path);

    std::filesystem::path path_;
    std::ofstream file_;
};

/// All whole rows of a history.
/// \throws InputError if the file is missing or no history.
std::vector<HistoryRow> read_history(const std::filesystem::path& path);

}  // namespace crawford
