#pragma once

#include <string>

#include "reports/gate.hpp"

/// Numbers and judgements in the words of the page.
namespace crawford::reports::page {

/// "1.23e-5", "0.95", "128"; "-" for what is no number.
std::string number(double value, int digits = 3);

/// "3.2 s", "1 min 40 s"
std::string duration(double seconds);

/// "pass", "FAIL" or "not gated".
std::string judgement(const GateResult& gate);

/// The class of style that goes with it: "pass", "fail" or "open".
std::string style_of(const GateResult& gate);

/// "T, L2"
std::string title(const GateResult& gate);

/// What is demanded: "order 2 ± 0.1", "between -1 and 1", "at most 3".
std::string demand(const GateResult& gate);

}  // namespace crawford::reports::page
