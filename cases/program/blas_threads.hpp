#pragma once

namespace crawford {

/// Keeps OpenBLAS to one thread: where several runs go on side by side, threads inside each only
/// get in each other's way. Does nothing if the program was loaded with another BLAS.
void use_one_blas_thread();

}  // namespace crawford
