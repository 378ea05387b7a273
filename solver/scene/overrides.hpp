/// Assignments from outside the file: surface.pressure=3 MPa.
#pragma once

#include <toml++/toml.h>

#include <string_view>

namespace crawford {

/// Puts "dotted.key=value" into `scene`. The value is TOML; what is not (3 MPa, bbar) is taken as a
/// string, so that quotes, which the shell would eat, are not needed. "dotted.key=" removes it.
/// Tables on the way are made where absent.
/// \throws InputError where the assignment has no key or no "=", the path runs through a value
///         that is no table, or a key to be removed is not there.
void apply_override(toml::table& scene, std::string_view assignment);

}  // namespace crawford
