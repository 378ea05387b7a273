#include "program/provenance.hpp"

#include "base/build_info.hpp"
#include "solver/files/machine.hpp"

namespace crawford {

nlohmann::ordered_json provenance(const CommandLine& command) {
    return {{"program", "crawford"},
            {"version", version()},
            {"revision", revision()},
            {"compiler", compiler()},
            {"flags", flags()},
            {"libraries", nlohmann::ordered_json::parse(libraries())},
            {"machine", nlohmann::ordered_json::parse(machine())},
            {"command", command}};
}

}  // namespace crawford
