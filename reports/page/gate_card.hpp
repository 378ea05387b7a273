/// One gate on the report's page.
#pragma once

#include "reports/judgement.hpp"
#include "reports/page/html.hpp"

namespace crawford::reports::page {

/// Where the card of a gate stands in the page: the `index`-th gate of all.
std::string anchor_of_gate(std::size_t index);

/// How it came out, as a coloured word.
Html badge(Mark mark);

/// One gate: what it demands and why, what was found on each grid, the judgement, the plot.
Html gate_card(const GateResult& gate, std::size_t index);

}  // namespace crawford::reports::page
