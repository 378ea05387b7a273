/// What this process has taken.
#pragma once

namespace crawford {

/// Largest memory this process has held so far [bytes].
long peak_memory();

}  // namespace crawford
