/// A clock that costs nothing where nobody reads it.
///
/// CHOLMOD takes the time before and after each dense block of a factorisation, some 40,000 times
/// for the projection of a pack, and keeps sums that only its own reports show. Reading the clock is
/// 4 % of a factorisation. Here it stands still; no number depends on it.
///
/// This takes the place of SuiteSparse's entry for the whole process, as openmp_entry.cpp does of
/// libgomp's: linked into programs, never part of a library.

extern "C" {

/// Declared by SuiteSparse_config.h: seconds since some moment.
double SuiteSparse_time() {  // NOLINT
    return 0.0;
}
}
