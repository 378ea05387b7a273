/// OpenBLAS without threads of its own.
///
/// OpenBLAS starts a thread for each core but one while it is loaded, before main(). Crawford has no use for
/// them (solver/linear_solvers/one_thread.hpp), and where memory is short they try for ever to get their work
/// space, 128 MB each, and the end of the program waits for them. With one core to count, it starts none.
///
/// This takes the place of OpenBLAS's entry for the whole process, as openmp_entry.cpp does of
/// libgomp's: linked into programs, never part of a library.

extern "C" {

/// Declared by OpenBLAS's common.h: how many cores there are for its threads.
int get_num_procs() {  // NOLINT
    return 1;
}
}
