#include "solver/scene/write_discs.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace crawford {

std::string discs_csv(const Discs& discs) {
    std::string source = discs.source;
    std::replace(source.begin(), source.end(), '\n', ' ');
    std::string csv =
        fmt::format("# {}\n# period = \"{} m\"\nx [m],y [m],radius [m]\n", source, discs.period);
    for (const Disc& disc : discs.discs)
        csv += fmt::format("{},{},{}\n", disc.x, disc.y, disc.radius);
    return csv;
}

}  // namespace crawford
