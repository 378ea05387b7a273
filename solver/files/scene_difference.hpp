/// Whether two scenes describe the same run.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace crawford {

/// Compares two scenes in canonical TOML. What may change between the parts of one run is left out:
/// the title, where it ends (time.end, time.until_steady), how long its steps are (time.step,
/// time.accuracy) and what it writes (output).
/// Numbers that are equal to rounding are equal: "0.02 ms" is "20 us".
/// \param where the first one's values stand, for the message
/// \returns nothing if they agree, else the first key that differs, with both values.
/// \throws InputError if one of them is no TOML.
std::optional<std::string> difference(const std::string& before, const std::string& scene,
                                      std::string_view where = "in the checkpoint");

}  // namespace crawford
