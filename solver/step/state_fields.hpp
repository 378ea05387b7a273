/// The one list of a State's fields. Whatever goes through all of them goes through it: the state
/// at the start, combination, comparison of shapes, checkpoints.
#pragma once

#include <tuple>

#include "solver/scene/scene.hpp"
#include "solver/step/state.hpp"

namespace crawford {

enum class Place { node_column, node, cell, stress_point };

template <class Member>
struct StateField {
    const char* name;  ///< also of its data set in a checkpoint
    const char* unit;
    Place place;
    bool (*wanted)(const Physics&);  ///< whether such a scene has it
    Member of;                       ///< of a State, the field
};

// Written out because clang deduces no aggregate's arguments before version 17 (P1816).
template <class Member>
StateField(const char*, const char*, Place, bool (*)(const Physics&), Member) -> StateField<Member>;

inline constexpr std::tuple state_fields{
    StateField{"surface", "m", Place::node_column, [](const Physics&) { return true; },
               [](auto& state) -> decltype(auto) { return (state.surface); }},
    StateField{"temperature", "K", Place::node, [](const Physics& p) { return p.heat; },
               [](auto& state) -> decltype(auto) { return (state.temperature); }},
    StateField{"velocity", "m/s", Place::node, [](const Physics& p) { return p.mechanics; },
               [](auto& state) -> decltype(auto) { return (state.velocity); }},
    StateField{"deviator", "Pa", Place::stress_point, [](const Physics& p) { return p.mechanics; },
               [](auto& state) -> decltype(auto) { return (state.stress.deviator); }},
    StateField{"pressure", "Pa", Place::cell, [](const Physics& p) { return p.mechanics; },
               [](auto& state) -> decltype(auto) { return (state.stress.pressure); }},
    StateField{"temperature_rate", "K/s", Place::cell,
               [](const Physics& p) { return p.heat && p.mechanics; },
               [](auto& state) -> decltype(auto) { return (state.temperature_rate); }},
    StateField{"reference_shift", "m", Place::node,
               [](const Physics& p) { return p.reference_map; },
               [](auto& state) -> decltype(auto) { return (state.reference_shift); }}};

/// Calls `visit(field)` for each StateField, in the order of the list.
template <class Visit>
void for_each_state_field(const Visit& visit) {
    std::apply([&](const auto&... field) { (visit(field), ...); }, state_fields);
}

}  // namespace crawford
