/// The mesh of a burning sandwich, graded into its notch.
#pragma once

#include "reference/sandwich_geometry.hpp"

namespace crawford::reference {

/// Mesh for a burning sandwich in x and y - phi(x): graded towards the interface over a third
/// of the strip on either side and over as much below the surface, coarser from there on.
/// \throws std::invalid_argument naming the parameter that is missing or out of range.
TensorSpace front_space(const SandwichGeometry& geometry, const SandwichElements& elements);

}  // namespace crawford::reference
