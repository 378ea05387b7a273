/// Parameters of a truth: what they are called, what they mean, what they may be.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace crawford::reference {

/// The range of a number; what is not finite is refused unless `infinite`.
struct Limits {
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
    bool open = false;      ///< the ends themselves are outside
    bool whole = false;     ///< 1, 2, 3, ...
    bool infinite = false;  ///< infinity is allowed, where the range goes that far

    bool contains(double value) const;
    std::string wanted(const std::string& unit) const;  ///< "above 0 m", "any finite number"
};

namespace limits {
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr Limits finite{};
inline constexpr Limits positive{.from = 0.0, .open = true};
inline constexpr Limits positive_or_infinite{.from = 0.0, .open = true, .infinite = true};
inline constexpr Limits not_negative{.from = 0.0};
}  // namespace limits

using ParameterValue = std::variant<double, std::string>;  ///< SI, or a text

struct Parameter {
    std::string name;
    std::string unit;  ///< SI; "1" for a pure number, empty for a text
    std::string meaning;
    std::optional<ParameterValue> standard;  ///< holds where nothing is given
    std::string otherwise{};                 ///< what holds where there is no one standard
    Limits limits{};                         ///< of a number
    std::vector<std::string> choices{};      ///< of a text; empty for a number

    bool is_text() const { return !choices.empty(); }
};

/// A number with a standard.
Parameter number(std::string name, std::string unit, double standard, Limits limits,
                 std::string meaning);
/// A text with a standard, one of `choices`.
Parameter text(std::string name, std::string standard, std::vector<std::string> choices,
               std::string meaning);

using Parameters = std::map<std::string, ParameterValue>;

/// The parameters of one truth, complete and within their limits.
class Given {
public:
    /// \throws InputError for an unknown parameter, naming the nearest, and for a value
    /// out of its limits, naming parameter, value and limit.
    Given(const std::vector<Parameter>& known, const Parameters& given);

    double number(const std::string& name) const;
    const std::string& text(const std::string& name) const;
    /// Of a number that has no one standard.
    double number_or(const std::string& name, double otherwise) const;

private:
    Parameters values_;
};

}  // namespace crawford::reference
