/// manifest.json: what it takes to know where a result comes from and to compute it again.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "solver/files/manifest_outcome.hpp"
#include "solver/files/step_choice.hpp"
#include "solver/guards/guard.hpp"

namespace crawford {

/// What a run came to in its last state.
struct RunResults {
    double regression_rate;                                  ///< V [m/s]
    double mean_burn_rate;                                   ///< [m/s]
    double largest_temperature;                              ///< [K]
    std::optional<double> strain_about_peak = std::nullopt;  ///< mean within 5 um
    std::optional<bool> steady = std::nullopt;               ///< where the scene asks for it
};

struct Manifest {
    ManifestOutcome outcome;
    std::vector<std::string> command;  ///< the command line
    std::string scene;                 ///< canonical TOML
    std::string left_out;              ///< of it, because it changes nothing; may be empty
    std::vector<std::uint64_t> seeds;
    std::optional<std::string> restarted_from;  ///< a checkpoint
    long first_step = 0;
    long last_step = 0;
    double time = 0.0;               ///< reached [s]
    std::optional<StepCount> steps;  ///< how they came about, where they were chosen
    Guards predicted;                ///< from the scene, before
    Guards met;                      ///< the worst of the run so far
    std::chrono::system_clock::time_point started;
    std::chrono::system_clock::time_point ended;
    double wall_seconds = 0.0;          ///< between the two, by a clock that nobody sets back
    std::optional<RunResults> results;  ///< of a run that is done
};

/// Writes it, with the build, the libraries, the machine, the wall time and the peak memory so far.
/// \throws InputError if the file cannot be written.
void write_manifest(const std::filesystem::path& path, const Manifest& manifest);

}  // namespace crawford
