/// Grid and steps for a wanted accuracy of the regression rate V, in measures of the scene's own, so
/// that they carry over to another flux, pressure or size.
///
/// Where the numbers come from: crawford run tradeoff and crawford verify presets (docs/trade.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/scene/scene.hpp"

namespace crawford {

struct Preset {
    std::string name;         ///< of its file, without the ending
    double error;             ///< of V that it promises, relative
    double rows_in_layer;     ///< D/r_b of the thinnest thermal layer over the lowest row's height
    double columns_in_layer;  ///< the same of the mean width of a column, where there are any
    double columns_in_feature;  ///< in a strip, or in the mean disc's diameter
    double clustering;          ///< domain.clustering
    double clustering_x;        ///< domain.clustering_x, where there is a strip
    double accuracy;            ///< time.accuracy, with time.step = "auto"
    double least_error;         ///< of V that was found where it was largest, relative
    double left_of_change;      ///< of what V changes by on half the grid, the error that is left
    double slowest, fastest;    ///< burn rates by which it was measured [m/s]
    std::string measured;       ///< what V was found to be off by, in words
};

/// \param file TOML
/// \throws InputError if it does not exist or a key is missing, of another kind or unknown.
Preset read_preset(const std::filesystem::path& file);

/// Half the rows and columns, and steps twice as long or four times less accurate: what an answer is
/// checked by.
Scene coarser(Scene scene);

/// What a preset comes to in a scene.
struct Chosen {
    std::vector<std::string> keys;     ///< "domain.nx=32", to be put into the scene
    std::vector<std::string> outside;  ///< in words, where the scene is beyond what was measured
    double seconds;                    ///< what it is expected to take on one core
    double megabytes;
};

/// \throws InputError if nothing burns in the scene: then there is no V.
Chosen choose(const Preset& preset, const Scene& scene);

}  // namespace crawford
