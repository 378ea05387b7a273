#include "base/digest.hpp"

#include <algorithm>
#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <fstream>
#include <iterator>
#include <vector>

#include "base/errors.hpp"

namespace crawford {

std::string digest(std::string_view text) {
    return to_string(
        boost::uuids::name_generator_sha1(boost::uuids::ns::oid())(text.data(), text.size()));
}

std::string digest_of_files(const std::filesystem::path& directory) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(directory))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    std::string all;
    for (const std::filesystem::path& path : files) {
        std::ifstream file(path, std::ios::binary);
        if (!file) throw InputError(path.string() + " cannot be read");
        const std::string text(std::istreambuf_iterator<char>(file), {});
        all += std::filesystem::relative(path, directory).generic_string() + '\n' + digest(text) +
               '\n';
    }
    return digest(all);
}

}  // namespace crawford
