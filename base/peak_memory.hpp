/// What this process has taken.
#pragma once

namespace crawford {

/// Largest memory this process has held so far [bytes].
long peak_memory();

/// From here on only what comes counts. Where the system does not let it, all still counts.
void forget_peak_memory();

}  // namespace crawford
