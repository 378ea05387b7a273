#include "reports/claim.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace crawford::reports {

double half_digit(const std::string& printed) {
    const size_t point = printed.find('.');
    const auto decimals = point == std::string::npos ? 0 : int(printed.size() - point - 1);
    return 0.5 * std::pow(10.0, -decimals);
}

LedgerRow judged(const Claim& claim, const Found& found) {
    if (!std::isfinite(found.value))
        throw std::invalid_argument(claim.claim + ": no number was found");
    LedgerRow row{.claim = claim.claim,
                  .where = claim.where,
                  .entry = claim.entry,
                  .unit = claim.unit,
                  .paper = claim.printed,
                  .ours = fmt::format(fmt::runtime(found.format), found.value),
                  .paper_value = claim.value,
                  .value = found.value,
                  .uncertainty = found.uncertainty,
                  .reading = found.reading};
    const double allowed = claim.open + found.uncertainty.total().value_or(0.0);
    const auto agrees = [&](double value) { return std::abs(value - claim.value) <= allowed; };
    const auto other = std::ranges::find_if(found.others, agrees, &OtherReading::value);
    const std::string apart =
        fmt::format("{:+.3g}{} from the paper's, {:.3g} allowed.", found.value - claim.value,
                    claim.unit == "-" ? "" : ' ' + claim.unit, allowed);
    if (agrees(found.value)) {
        row.standing = Standing::reproduced;
        row.why = apart;
    } else if (other != found.others.end()) {
        row.standing = Standing::other_reading;
        row.why = fmt::format("{:.4g} with: {}. As read, {}", other->value, other->reading, apart);
    } else {
        row.standing = Standing::not_reproduced;
        row.why = apart;
    }
    if (!found.because.empty()) row.why += ' ' + found.because;
    return row;
}

LedgerRow judged(const Statement& statement) {
    return {.claim = statement.claim,
            .where = statement.where,
            .entry = statement.entry,
            .unit = "-",
            .paper = statement.printed,
            .ours = statement.ours,
            .reading = statement.reading,
            .standing = statement.holds ? Standing::reproduced : Standing::not_reproduced,
            .why = statement.because};
}

}  // namespace crawford::reports
