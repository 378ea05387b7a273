/// Functions of true place and time, as manufactured sources are given.
#pragma once

#include <functional>

namespace crawford {

/// A value at (x [m], y [m], t [s]). An empty one is zero and costs nothing.
template <class Value>
using SpaceTimeFunction = std::function<Value(double x, double y, double t)>;

}  // namespace crawford
