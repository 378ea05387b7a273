/// Where a result comes from, stamped into every file that may travel alone.
#pragma once

#include <string>

namespace crawford {

struct Provenance {
    std::string scene;     ///< canonical TOML
    std::string version;   ///< of the program
    std::string revision;  ///< of its sources, from git
};

}  // namespace crawford
