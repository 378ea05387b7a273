/// What runs have done, counted beside the clock that times them.
#pragma once

namespace crawford {

/// Zero where nothing was stepped through time.
struct WorkDone {
    long steps = 0;
    long cells = 0;              ///< of the largest grid
    long solver_iterations = 0;  ///< of iterative linear solvers; a direct one has none
};

/// Of this thread since it last set it to zero. As the thread's clock of CPU seconds is, it is one
/// for all that the thread runs, so that what is timed need not hand a counter down to each step.
WorkDone& work_of_this_thread();

}  // namespace crawford
