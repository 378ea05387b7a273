/// The course of a run as one table: `<name>_history.csv`.
#pragma once

#include <array>
#include <filesystem>
#include <fstream>
#include <vector>

namespace crawford {

/// One row. What the scene does not compute is 0.
struct HistoryRow {
    double time = 0.0;                 ///< [s]
    double mean_burn_rate = 0.0;       ///< [m/s]
    double largest_temperature = 0.0;  ///< [K]
    double largest_strain = 0.0;
    double residual = 0.0;
    double solver_iterations = 0.0;
    double strain_about_peak = 0.0;    ///< mean over peak_radius about the largest; see Peak
    double largest_pressure = 0.0;     ///< [Pa]
    double pressure_about_peak = 0.0;  ///< likewise [Pa]
    double regression_rate = 0.0;      ///< drop of the mean height in the last step, per time [m/s]
    double least_temperature = 0.0;    ///< [K]
    double largest_slope = 0.0;        ///< of the surface, in magnitude
    double step = 0.0;                 ///< length of the last step [s]
};

/// A column of the file: its heading, with the unit, and the member that it holds.
struct HistoryColumn {
    const char* heading;
    double HistoryRow::*member;
};

/// All of them, in the order of the file: writing and reading go through this list.
inline constexpr std::array history_columns{
    HistoryColumn{"time [s]", &HistoryRow::time},
    HistoryColumn{"mean burn rate [m/s]", &HistoryRow::mean_burn_rate},
    HistoryColumn{"max T [K]", &HistoryRow::largest_temperature},
    HistoryColumn{"max strain [-]", &HistoryRow::largest_strain},
    HistoryColumn{"residual [-]", &HistoryRow::residual},
    HistoryColumn{"solver iterations", &HistoryRow::solver_iterations},
    HistoryColumn{"strain within 5 um of max [-]", &HistoryRow::strain_about_peak},
    HistoryColumn{"max p [Pa]", &HistoryRow::largest_pressure},
    HistoryColumn{"p within 5 um of max [Pa]", &HistoryRow::pressure_about_peak},
    HistoryColumn{"regression rate [m/s]", &HistoryRow::regression_rate},
    HistoryColumn{"min T [K]", &HistoryRow::least_temperature},
    HistoryColumn{"max slope [-]", &HistoryRow::largest_slope},
    HistoryColumn{"step [s]", &HistoryRow::step},
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
