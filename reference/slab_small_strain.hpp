/// How far the Eulerian slab is from that of small strain, to first order.
#pragma once

#include "reference/slab_conditions.hpp"

namespace crawford::reference {

/// d T_s/d(theta) [K^2] at fixed beta theta, where theta = 0 is the half space of Kuznetsov and
/// Stewart: how the surface temperature of the Eulerian model leaves theirs. With G = r_b g,
/// D = T_s - T0 and a given burn rate, g_E = g_KS + theta g_1 + O(theta^2), where
///
///     g_1 = integral from 0 to D of d (rho c_p + s beta theta (T0 + d)) dd
///
/// with s of reference/slab_energy.hpp is the heat that the stretch theta d carries beside r_b, so
/// that
///
///     d T_s/d(theta) = -g_1/(rho c_p + s beta theta T_s).
///
/// \param conditions of either model; K and mu times N^2 with alpha over N leaves the result alone.
/// \throws std::invalid_argument naming the missing or out-of-range parameter; where r_b is not
/// prescribed or the slab not a half space.
double small_strain_sensitivity(const SlabConditions& conditions);

}  // namespace crawford::reference
