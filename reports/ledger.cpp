#include "reports/ledger.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <stdexcept>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "base/json_problem.hpp"
#include "reports/ledger_json.hpp"

namespace crawford::reports {

using Json = nlohmann::ordered_json;

std::string_view name(Standing standing) {
    switch (standing) {
        case Standing::reproduced:
            return "reproduced";
        case Standing::other_reading:
            return "reproduced under another reading";
        case Standing::not_reproduced:
            return "not reproduced";
    }
    throw std::logic_error("a standing without a name");
}

std::optional<double> Uncertainty::total() const {
    std::optional<double> squares;
    for (const auto& part : {grid, step, packs})
        if (part) squares = squares.value_or(0.0) + *part * *part;
    if (!squares) return {};
    return std::sqrt(*squares);
}

void write(const std::filesystem::path& file, const Ledger& ledger) {
    write_file(file, Json(ledger).dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

Ledger read_ledger(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in || std::filesystem::is_directory(file))
        throw InputError(fmt::format("{} cannot be read", file.string()));
    try {
        const auto document = Json::parse(in);
        return ledger_of(JsonMember(document));
    } catch (const std::runtime_error& problem) {
        throw InputError(fmt::format("{}: {}", file.string(), problem.what()));
    } catch (const Json::exception& problem) {
        throw InputError(fmt::format("{}: {}", file.string(), json_problem(problem.what())));
    }
}

}  // namespace crawford::reports
