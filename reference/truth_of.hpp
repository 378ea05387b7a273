/// The common face of a truth that is at hand; truth_registry.hpp makes one by name.
#pragma once

#include "reference/truth.hpp"

namespace crawford::reference {

class FadedInclusion;
class ManufacturedElasticity;
class ManufacturedStrip;
class Slab;

Truth truth_of(const Slab& slab);                       ///< fields: find_truth("slab")
Truth truth_of(const FadedInclusion& inclusion);        ///< fields: find_truth("faded-inclusion")
Truth truth_of(const ManufacturedElasticity& elastic);  ///< displacement, stress, body force
Truth truth_of(const ManufacturedStrip& strip);         ///< likewise

}  // namespace crawford::reference
