/// Keeps the linear algebra libraries from starting threads of their own.
#pragma once

#include <shared_mutex>

namespace crawford {

/// As long as it is held its thread may call OpenBLAS, beside others.
using Calls = std::shared_lock<std::shared_mutex>;

/// One thread for OpenMP regions that the calling thread opens, and for OpenBLAS. CHOLMOD asks for
/// four threads for dense blocks of a few dozen rows: a step of a sandwich takes twice as long with
/// them, and runs side by side get in each other's way. Two runs at a time use two cores better
/// than one run on both.
/// \throws std::bad_alloc if there is no room for the work space of OpenBLAS.
[[nodiscard]] Calls use_one_thread();

}  // namespace crawford
