#include "base/digest.hpp"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

namespace crawford {

std::string digest(std::string_view text) {
    return to_string(
        boost::uuids::name_generator_sha1(boost::uuids::ns::oid())(text.data(), text.size()));
}

}  // namespace crawford
