/// By what a run is known: its physics, its numerics and its end. What it writes is a request to
/// it.
#pragma once

#include <string>
#include <vector>

#include "solver/scene/scene.hpp"

namespace crawford {

/// The scene without its title and its output: two runs of one identity have the same bits at every
/// step, whatever they write. (A checkpoint makes a run drop its factorisation; the next one is of
/// the same order and so has the same bits.)
std::string identity_of(const Scene& scene);

/// A digest of identity_of(scene), in full: the name of a run among any number of them.
std::string key_of(const Scene& scene);

/// Whether what a run with the output `kept` has written holds all that `wanted` asks for: every
/// time of the one is a time of the other.
/// \param step of time, in which intervals are counted [s]
bool covers(const Output& kept, const Output& wanted, double step);

/// The least output that covers both.
Output united(const Output& a, const Output& b, double step);

/// Each run once, with the output that covers all that is asked of it.
std::vector<Scene> united(const std::vector<Scene>& scenes);

/// "AP/binder pack, 72 %, 120 x 96, 25 us", for progress.
std::string run_title(const Scene& scene);

/// Rough wall time of a run from its start on one core [s], to tell the long from the short.
double expected_seconds(const Scene& scene);

}  // namespace crawford
