/// Numbers and judgements in the words of the page.
#pragma once

#include <string>

#include "reports/judgement.hpp"

namespace crawford::reports::page {

/// "1.23e-5", "0.95", "128"; "-" for what is no number.
std::string number(double value, int digits = 3);

/// "0.42 cm/s"; the number alone if there is no unit ("" or "-").
std::string with_unit(const std::string& number, const std::string& unit);

/// "mean burn rate [cm/s]", likewise.
std::string labelled(const std::string& quantity, const std::string& unit);

/// By how much a value is off, of the true one: "-0.95 %", "+240 %"; from ten times or a tenth on,
/// where a per cent says nothing, its factor: "15 times", "6.6e-8 times".
std::string percent_off(double value, double truth);

/// "3.2 s", "1 min 40 s"
std::string duration(double seconds);

/// The class of style of what came out so: "pass", "fail" or "open".
std::string style_of(Mark mark);

/// "T, L2"
std::string title(const GateResult& gate);

/// What is demanded: "order 2 ± 0.1", "between -1 and 1", "at most 3".
std::string demand(const GateResult& gate);

}  // namespace crawford::reports::page
