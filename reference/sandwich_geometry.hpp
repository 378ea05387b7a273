/// Half a sandwich, and how finely it is resolved.
#pragma once

#include "reference/material.hpp"
#include "reference/tensor_space.hpp"

namespace crawford::reference {

/// One half of a periodic sandwich with a flat surface: a strip of `inner` for 0 <= x < strip,
/// `outer` from there to half_width, -depth <= y <= 0. Both sides are planes of mirror symmetry.
/// Lengths in m.
struct SandwichGeometry {
    Material inner = binder();
    Material outer = ap();
    double strip = missing;       ///< half the width of the strip
    double half_width = missing;  ///< half the period
    double depth = missing;
};

/// The paper's sandwich (section 5.1, L = 120 um) with a strip of 60 um.
inline SandwichGeometry paper_sandwich() {
    return {.strip = 30e-6, .half_width = 120e-6, .depth = 480e-6};
}

/// How finely a sandwich is resolved: polynomial degree, and geometric layers around the interface,
/// below the surface and above the bottom.
struct SandwichElements {
    int degree = 8;
    int layers = 6;
    double ratio = 0.3;  ///< width of a layer over that of the one before
};

/// The graded mesh.
/// \throws std::invalid_argument naming the parameter that is missing or out of range.
TensorSpace sandwich_space(const SandwichGeometry& geometry, const SandwichElements& elements);

/// Whether an element lies in the strip; none straddles the interface.
bool in_strip(const SandwichGeometry& geometry, const TensorSpace::Element& element);

/// What fills an element.
const Material& material_of(const SandwichGeometry& geometry, const TensorSpace::Element& element);

}  // namespace crawford::reference
