#include "reports/page/words.hpp"

#include <fmt/format.h>

#include <cmath>

namespace crawford::reports::page {

std::string number(double value, int digits) {
    if (std::isnan(value)) return "\u2013";
    auto text = fmt::format("{:.{}g}", value, digits);
    const auto e = text.find('e');
    if (e == std::string::npos) return text;
    return fmt::format("{}e{}", text.substr(0, e), std::stoi(text.substr(e + 1)));
}

std::string with_unit(const std::string& number, const std::string& unit) {
    return unit.empty() || unit == "-" ? number : number + ' ' + unit;
}

std::string labelled(const std::string& quantity, const std::string& unit) {
    return with_unit(quantity, unit.empty() || unit == "-" ? "" : '[' + unit + ']');
}

std::string percent_off(double value, double truth) {
    const double factor = value / truth;
    if (factor > 0.0 && (factor >= 10.0 || factor <= 0.1)) return number(factor, 2) + " times";
    const double percent = 100.0 * (factor - 1.0);
    return std::abs(percent) < 10.0 ? fmt::format("{:+.2g} %", percent)
                                    : fmt::format("{:+.0f} %", percent);
}

std::string duration(double seconds) {
    if (seconds < 1.0) return fmt::format("{:.2f} s", seconds);
    if (seconds < 100.0) return fmt::format("{:.1f} s", seconds);
    const long whole = std::lround(seconds);
    return fmt::format("{} min {} s", whole / 60, whole % 60);
}

std::string style_of(Mark mark) {
    switch (mark) {
        case Mark::pass:
            return "pass";
        case Mark::fail:
            return "fail";
        case Mark::not_gated:
            break;
    }
    return "open";
}

std::string title(const GateResult& gate) {
    return gate.norm.empty() ? gate.quantity : gate.quantity + ", " + gate.norm;
}

std::string demand(const GateResult& gate) {
    if (gate.kind == GateKind::bound) {
        if (std::isinf(gate.low)) return "at most " + number(gate.high, 5);
        if (std::isinf(gate.high)) return "at least " + number(gate.low, 5);
        return fmt::format("between {} and {}", number(gate.low, 5), number(gate.high, 5));
    }
    const auto order = "order " + number(gate.expected);
    if (gate.below == gate.above) return order + " \u00b1 " + number(gate.below);
    if (std::isinf(gate.above)) return order + " \u2212 " + number(gate.below) + " or better";
    return fmt::format("{} \u2212 {} + {}", order, number(gate.below), number(gate.above));
}

}  // namespace crawford::reports::page
