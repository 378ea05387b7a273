/// Keeps METIS from taking SIGTERM away from the program.
///
/// METIS orders the unknowns of the projection. While it works it puts a handler of its own in place of the
/// process's handlers of SIGTERM and SIGABRT, which jumps to where METIS was called, and afterwards puts back what was there (GKlib,
/// gk_sigtrap). Where two threads order at once, one of them puts back the other's handler, and a
/// later SIGTERM jumps into a call that has long returned. SIGTERM is the program's own
/// (program/interrupt.hpp): a request for it is left aside here.
///
/// This takes the place of the C library's entry for the whole process. That is a program's choice:
/// the file is linked into programs, as an object of its own, and never part of a library.

#include <csignal>

extern "C" {

/// What METIS is compiled to call for signal(): the handler stays for one signal (System V).
__sighandler_t __sysv_signal(int number, __sighandler_t handler) noexcept {  // NOLINT
    if (number == SIGTERM) return SIG_DFL;
    struct sigaction asked {};
    struct sigaction before {};
    asked.sa_handler = handler;
    asked.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
    return sigaction(number, &asked, &before) == 0 ? before.sa_handler : SIG_ERR;
}
}
