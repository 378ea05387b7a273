/// The clock of one thread.
#pragma once

namespace crawford {

/// CPU time that this thread has taken [s].
double seconds_of_this_thread();

}  // namespace crawford
