/// Which Crawford this is, for manifests and `--version`.
#pragma once

#include <string>

namespace crawford {

std::string version();  ///< of the project, for example "0.1.0"
std::string
revision();  ///< commit, with "-dirty" where files differ from it; "unknown" outside git
std::string compiler();  ///< name and version, for example "GNU 12.2.0"
std::string flags();     ///< compiler flags of this kind of build

}  // namespace crawford
