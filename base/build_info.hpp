/// Which Crawford this is, for manifests and `--version`.
#pragma once

#include <string>

namespace crawford {

std::string version();  ///< of the project, for example "0.1.0"
std::string
revision();  ///< commit, with "-dirty" where files differ from it; "unknown" outside git
/// Changes with any source of the solver, the compiler and its flags: a burn of the same scene and
/// fingerprint has the same bits.
std::string solver_fingerprint();
std::string source_fingerprint();  ///< the same for all that figures are made of
std::string compiler();            ///< name and version, for example "GNU 12.2.0"
std::string flags();               ///< compiler flags of this kind of build

}  // namespace crawford
