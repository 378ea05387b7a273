/// A step of third order in time out of Euler steps (Shu & Osher 1988): where a study evolves one
/// module by itself, the error in time must not hide the error in space.
#pragma once

namespace crawford {

/// \param euler state -> state after dt
/// \param blend (a, x, b, y) -> a x + b y
template <class State, class Euler, class Blend>
State ssp_step(const State& start, const Euler& euler, const Blend& blend) {
    const State half = blend(0.75, start, 0.25, euler(euler(start)));
    return blend(1.0 / 3.0, start, 2.0 / 3.0, euler(half));
}

}  // namespace crawford
