/// Discs side by side in a box that repeats itself in x and y.
#pragma once

#include <string>
#include <vector>

namespace crawford {

struct Disc {
    double x, y, radius;  ///< [m]
};

struct Discs {                ///< discs of the first material in a matrix of the second
    std::vector<Disc> discs;  ///< periodic in x with the domain's width
    double period;            ///< periodic in y with this [m]; the burning surface starts at y = 0
    std::string source = "";  ///< where they come from, for the manifest
};

}  // namespace crawford
