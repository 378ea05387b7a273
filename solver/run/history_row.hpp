/// A row of the history from a simulation.
#pragma once

#include "solver/files/history.hpp"
#include "solver/files/widening.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

/// What the history says of the present state, in the shape that was asked for.
HistoryRow history_row(const Simulation& simulation, const Summary& summary,
                       const Widening& widening);

}  // namespace crawford
