#include "reports/page/ledger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/page/document.hpp"
#include "reports/page/ledger_claims.hpp"
#include "reports/page/ledger_grounds.hpp"
#include "reports/page/manifest.hpp"

namespace crawford::reports::page {
namespace {

Html counts(const Ledger& ledger) {
    const auto count = [&](Standing standing) {
        return std::ranges::count(ledger.rows, standing, &LedgerRow::standing);
    };
    return styled("p", "count-of-all",
                  fmt::format("{} claims: {} reproduced, {} under another reading, {} not",
                              ledger.rows.size(), count(Standing::reproduced),
                              count(Standing::other_reading), count(Standing::not_reproduced)));
}

Html not_reproduced(const Ledger& ledger) {
    const auto anchors = anchors_of(ledger.rows);
    Html items;
    for (std::size_t k = 0; k < ledger.rows.size(); ++k)
        if (ledger.rows[k].standing == Standing::not_reproduced)
            items += element("li", {},
                             "Not reproduced: " + link(anchors[k], ledger.rows[k].claim) + ", " +
                                 ledger.rows[k].where);
    return items.empty() ? Html() : styled("ul", "shortcomings", items);
}

}  // namespace

std::string ledger_page(const Ledger& ledger, const std::vector<std::string>& pages) {
    const Html head =
        element("header", {},
                element("h1", {}, "Crawford: ledger of the paper's claims") + counts(ledger) +
                    circumstances(ledger.manifest) + not_reproduced(ledger));
    return document("Crawford: ledger", navigation({{"index.html", "figures"}}) + head + "\n" +
                                            table_of_claims(ledger.rows, pages) +
                                            readings(ledger.readings) +
                                            refinements(ledger.refinements) +
                                            spreads(ledger.spreads) + manifest(ledger.manifest));
}

}  // namespace crawford::reports::page
