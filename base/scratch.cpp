#include "base/scratch.hpp"

#include <cstdlib>
#include <string>
#include <system_error>

#include "base/errors.hpp"

namespace crawford {

namespace fs = std::filesystem;

Scratch::Scratch() {
    std::string pattern = (fs::temp_directory_path() / "crawford-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
        throw InputError("cannot make a directory below " + fs::temp_directory_path().string());
    path_ = pattern;
}

Scratch::~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

}  // namespace crawford
