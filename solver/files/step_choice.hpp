/// What the choice of the next step rests on: all that a checkpoint keeps of it.
#pragma once

#include <vector>

namespace crawford {

/// Divided differences over the last steps of the temperatures of the surface's nodes.
struct StepMemory {
    std::vector<double> slope;      ///< first differences; empty before the first step
    std::vector<double> curvature;  ///< second ones; empty before the second step
    double length = 0.0;            ///< of the last step [s]
    double length_before = 0.0;     ///< of the one before it [s]
    double fastest = 0.0;           ///< largest mean rate so far [m/s]
};

/// How the steps of a run came about.
struct StepCount {
    long rejected = 0;      ///< for their error or a cell crossed, and tried again
    long failed = 0;        ///< and tried again, shorter
    double shortest = 0.0;  ///< [s]
    double longest = 0.0;   ///< [s]
};

struct StepChoice {
    double next = 0.0;   ///< [s]
    double limit = 0.0;  ///< below which steps did not fail of late [s]
    StepMemory memory;
    StepCount count;
};

}  // namespace crawford
