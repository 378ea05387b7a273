/// Named readings of what the paper leaves open (docs/readings.md): one word for several keys.
///
/// A scene holds the keys and not the word, so that one physics is one scene, by whichever keys it
/// was asked for. What is written beside the keys is the word that they amount to.
#pragma once

#include <optional>

#include "solver/scene/scene.hpp"

namespace crawford {

enum class Readings {
    paper,      ///< as it computes: c_p beside the heat that expansion takes; to replicate
    consistent  ///< as thermodynamics has it: c_v beside that heat; to predict
};

/// Sets the readings of the thermal stress, its work, the heat capacity and the surface's motion.
/// A rigid conductor takes c_p by either: nothing in it takes the difference to c_v.
void apply(Readings readings, const Physics& physics, Numerics& numerics);

/// The word that the keys amount to; `paper` where both do, none where neither does.
std::optional<Readings> readings_of(const Physics& physics, const Numerics& numerics);

}  // namespace crawford
