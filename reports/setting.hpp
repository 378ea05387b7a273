/// What one run was set to: named axes with values that carry their kind.
///
///     columns = 64, rows = 96, step = 2e-05 s, element = bbar
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace crawford::reports {

/// A number with its unit.
struct Amount {
    double value;
    std::string unit;

    bool operator==(const Amount&) const = default;
};

/// A count (cells, steps), a physical quantity or a word.
using AxisValue = std::variant<long, Amount, std::string>;

/// "64", "2e-05 s", "bbar": the digits it takes to read the same number again.
std::string text(const AxisValue& value);

/// Axes in the order in which they were set. Names are those of the scene's keys where there is
/// one.
class Setting {
public:
    using Axis = std::pair<std::string, AxisValue>;

    /// An axis that is there already takes the new value.
    Setting& set(const std::string& axis, AxisValue value);

    const std::vector<Axis>& axes() const { return axes_; }
    bool has(const std::string& axis) const;

    /// \throws std::invalid_argument naming the axis if there is none of this name and kind.
    int count(const std::string& axis) const;
    double number(const std::string& axis) const;  ///< in the unit it was set in
    const std::string& word(const std::string& axis) const;

    /// "rows = 96, step = 2e-05 s": by which a run is known.
    std::string text() const;

    bool operator==(const Setting&) const = default;

private:
    template <class Value>
    const Value& get(const std::string& axis, const char* kind) const;

    std::vector<Axis> axes_;
};

}  // namespace crawford::reports
