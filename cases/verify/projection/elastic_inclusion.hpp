/// One step of the projection around a disc, against the exact inclusion.
#pragma once

#include "cases/verify/known_values.hpp"
#include "reference/faded_inclusion.hpp"
#include "reports/measurement.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

/// Of a disc and what is around it; K and mu are used.
struct DiscAndMatrix {
    reference::Material disc, matrix;
};

/// A disc of 40 um on no grid line, loaded by shear and pressure from far away, in a clamped window
/// of 240 um square; near its sides the exact field has faded to nothing.
reference::FadedInclusion faded_inclusion(const DiscAndMatrix& pair);
Scene inclusion_scene(const DiscAndMatrix& pair, int cells);

/// Errors of "displacement" and "stress" after one step from rest, each quantity with `suffix`.
void measure_inclusion(const Scene& scene, const reference::FadedInclusion& exact,
                       const std::string& suffix, reports::Measurement& result);

/// Displacements and stresses at nodes after the same step.
std::vector<KnownValue> values_of_inclusion(const Scene& scene,
                                            const reference::FadedInclusion& exact,
                                            const std::vector<Place>& places);

}  // namespace crawford
