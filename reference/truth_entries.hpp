/// The entries of the registry. A static library drops objects that nobody names, so
/// truth_registry.cpp names each.
#pragma once

#include "reference/truth_registry.hpp"

namespace crawford::reference {

TruthEntry slab_entry();
TruthEntry slab_shooting_entry();
TruthEntry slab_small_strain_entry();
TruthEntry adiabatic_column_entry();
TruthEntry travelling_layer_entry();
TruthEntry thermal_laminate_entry();
TruthEntry conducting_inclusion_entry();
TruthEntry thermal_sandwich_entry();
TruthEntry elastic_laminate_entry();
TruthEntry circular_inclusion_entry();
TruthEntry faded_inclusion_entry();
TruthEntry elastic_sandwich_entry();
TruthEntry williams_corner_entry();
TruthEntry rigid_rotation_entry();
TruthEntry simple_shear_entry();
TruthEntry uniaxial_flow_entry();
TruthEntry wavy_shear_entry();
TruthEntry carried_profile_entry();
TruthEntry regressing_wave_entry();
TruthEntry regressing_wave_envelope_entry();
TruthEntry regressing_zigzag_entry();
TruthEntry flux_response_entry();
TruthEntry flux_response_shooting_entry();
TruthEntry front_ripple_entry();
TruthEntry swinging_front_entry();
TruthEntry jumping_front_entry();
TruthEntry refracted_front_entry();
TruthEntry burning_sandwich_front_entry();
TruthEntry manufactured_heat_entry();
TruthEntry manufactured_elastic_body_entry();
TruthEntry manufactured_elastic_strip_entry();
TruthEntry manufactured_burning_entry();

}  // namespace crawford::reference
