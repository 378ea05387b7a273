#include "solver/files/machine.hpp"

#include <cholmod.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <hdf5.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <Eigen/Core>
#include <boost/version.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "base/room.hpp"

namespace crawford {

namespace {

using Json = nlohmann::ordered_json;

/// Names come from the system, in whatever bytes it has.
std::string text_of(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// What follows `key`, separators and quotes on the first line of `path` that begins with it.
std::string value_in(const char* path, const std::string& key) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with(key)) continue;
        const size_t begin = line.find_first_not_of(" \t:=\"", key.size());
        if (begin == std::string::npos) break;
        return line.substr(begin, line.find_last_not_of('"') + 1 - begin);
    }
    return "unknown";
}

std::string system_name() {
    utsname system{};
    if (uname(&system) != 0) return "unknown";
    return fmt::format("{}, {} {} {}", value_in("/etc/os-release", "PRETTY_NAME"), system.sysname,
                       system.release, system.machine);
}

std::string blas() {
    using Description = char* (*)();
    const auto description =
        reinterpret_cast<Description>(dlsym(RTLD_DEFAULT, "openblas_get_config"));
    return description ? description() : "unknown";
}

std::string hdf5() {
    look_for_room(
        for_a_library);  // HDF5's first call makes its tables, and ends by a signal without
    unsigned major = 0, minor = 0, release = 0;
    H5get_libversion(&major, &minor, &release);
    return fmt::format("{}.{}.{}", major, minor, release);
}

std::string cholmod() {
    int version[3] = {};
    cholmod_version(version);
    return fmt::format("{}.{}.{}", version[0], version[1], version[2]);
}

}  // namespace

std::string machine() {
    const long memory = sysconf(_SC_PHYS_PAGES) * sysconf(_SC_PAGE_SIZE);
    return text_of({{"processor", value_in("/proc/cpuinfo", "model name")},
                    {"cores", std::thread::hardware_concurrency()},
                    {"memory_bytes", memory},
                    {"system", system_name()}});
}

std::string libraries() {
    return text_of({{"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                                          EIGEN_MINOR_VERSION)},
                    {"CHOLMOD", cholmod()},
                    {"BLAS", blas()},
                    {"HDF5", hdf5()},
                    {"Boost", fmt::format("{}.{}.{}", BOOST_VERSION / 100000,
                                          BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)}});
}

}  // namespace crawford
