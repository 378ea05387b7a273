#include "solver/output/history.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <string>

#include "solver/errors.hpp"
#include "solver/output/atomic_file.hpp"

namespace crawford {

namespace {

const std::string header =
    "time [s],mean burn rate [m/s],max T [K],max strain [-],residual [-],solver iterations\n";

/// The part of a history up to and including `time`.
std::string rows_until(const std::string& text, double time) {
    size_t begin = header.size();
    while (true) {
        const size_t end = text.find('\n', begin);
        if (end == std::string::npos) break;
        double row_time = 0.0;
        const auto [_, error] = std::from_chars(text.data() + begin, text.data() + end, row_time);
        if (error != std::errc() || row_time > time) break;
        begin = end + 1;
    }
    return text.substr(0, begin);
}

}  // namespace

History::History(const std::filesystem::path& path)
    : path_(path), file_(path, std::ios::binary | std::ios::app) {
    if (!file_)
        throw InputError(fmt::format("cannot write {}: {}", path.string(), strerror(errno)));
}

History History::start(const std::filesystem::path& path) {
    write_file(path, header);
    return History(path);
}

History History::resume(const std::filesystem::path& path, double time) {
    std::ifstream old(path, std::ios::binary);
    if (!old) return start(path);
    const std::string text(std::istreambuf_iterator<char>(old), {});
    if (!text.starts_with(header))
        throw InputError(
            fmt::format("cannot go on with {}: it does not begin with the header of a "
                        "history; move it away or choose another directory",
                        path.string()));
    write_file(path, rows_until(text, time));
    return History(path);
}

void History::append(const HistoryRow& row) {
    file_ << fmt::format("{},{},{},{},{},{}\n", row.time, row.mean_burn_rate,
                         row.largest_temperature, row.largest_strain, row.residual,
                         row.solver_iterations)
          << std::flush;
    if (!file_)
        throw InputError(fmt::format("cannot write {}: {}", path_.string(), strerror(errno)));
}

}  // namespace crawford
