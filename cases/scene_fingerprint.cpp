#include "cases/scene_fingerprint.hpp"

#include "base/digest.hpp"
#include "base/program_fingerprint.hpp"
#include "base/source_tree.hpp"

namespace crawford {

std::string fingerprint_with_scenes() {
    return digest(program_fingerprint() + digest_of_files(source_path("cases/scenes")));
}

}  // namespace crawford
