/// What the catalogue is about: the headings of its index by physics.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace crawford {

struct Entry;

namespace physics {

inline constexpr auto heat = "heat";
inline constexpr auto burning = "burning surface";
inline constexpr auto stress = "stress and projection";
inline constexpr auto coupling = "thermo-mechanical coupling";
inline constexpr auto reference_map = "reference map and strain";
inline constexpr auto materials = "material properties";
inline constexpr auto morphology = "morphology";
inline constexpr auto grid = "grid";
inline constexpr auto time = "time step";
inline constexpr auto slab = "homogeneous slab";
inline constexpr auto sandwich = "sandwich";
inline constexpr auto pack = "random pack";

inline constexpr std::array all{heat,       burning, stress, coupling, reference_map, materials,
                                morphology, grid,    time,   slab,     sandwich,      pack};

/// The heading that a term of the equations (terms.hpp) comes under; empty if it is no term of the
/// model, which the coverage matrix tells.
std::string_view of_term(std::string_view term);

}  // namespace physics

/// The headings that an entry comes under, in the order of physics::all: those it states and those
/// of the terms that its studies cover.
std::vector<std::string> physics_of(const Entry& entry);

}  // namespace crawford
