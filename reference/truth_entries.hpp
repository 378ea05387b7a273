/// The entries of the registry. A static library drops objects that nobody names, so
/// truth_registry.cpp names each.
#pragma once

#include "reference/truth_registry.hpp"

namespace crawford::reference {

TruthEntry slab_entry();
TruthEntry slab_shooting_entry();
TruthEntry slab_small_strain_entry();
TruthEntry elastic_laminate_entry();
TruthEntry manufactured_burning_entry();

}  // namespace crawford::reference
