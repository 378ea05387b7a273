/// Random packs of discs, by growth: the algorithm of Lubachevsky and Stillinger (docs/packs.md).
#pragma once

#include <cstdint>
#include <vector>

#include "solver/packing/discs.hpp"

namespace crawford {

struct DiscSize {
    double radius;  ///< [m]
    int count;
};

struct PackRecipe {
    double width;  ///< period in x [m]
    std::vector<DiscSize> discs;
    double area_fraction;  ///< of the discs
    double smallest_gap;   ///< between any two rims, periodic images included [m]
    std::uint64_t seed;
};

/// The period in y [m] with which the discs have exactly their area fraction: the radii stay as
/// they are given and so does the width.
double period(const PackRecipe&);

/// Discs at random, in the order of the recipe, x in [-width/2, width/2), y in (-period, 0]. They
/// have grown from points together, moving and colliding, and then moved on without growing until
/// they had forgotten it. The same recipe gives the same discs, to the last bit, on any machine.
/// \throws InputError if a disc does not fit into the box, or the discs have jammed: it names the
///         fraction that they have reached
Discs random_pack(const PackRecipe&);

/// The smallest gap between two rims, periodic images included and a disc's own too [m]; negative
/// where discs overlap.
double smallest_gap(const Discs&, double width);

/// Area of the discs, none overlapping, over that of the box.
double area_fraction(const Discs&, double width);

}  // namespace crawford
