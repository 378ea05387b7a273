/// How strongly heating answers the stretch that heating brings about.
///
/// A layer that cannot widen sideways stretches by div v = (beta_s/P) DT/Dt, and that stretch cools
/// it by -beta_w T div v. Where a step takes div v from the step before, its DT/Dt answers the last
/// one's with a factor; the coupling number is that factor with its sign turned:
///
///     lagged      g = beta_w beta_s T/(P rho c)
///     adiabatic   g = (beta_w beta_s T/P - s)/(rho c + s),  s = beta_w^2 T/K
///
/// Split adiabatically with beta_w = beta_s it is never positive: the remainder never alternates.
#pragma once

#include <string>

#include "solver/scene/scene.hpp"

namespace crawford {

/// What a coupling number is made of, at a point of the solid.
struct CoupledSolid {
    double heat_capacity;    ///< rho c [J/(m^3 K)], c_p or c_v as the scene says
    double bulk_modulus;     ///< K [Pa]
    double shear_modulus;    ///< mu [Pa]
    double stress_of_heat;   ///< beta_s of the thermal stress [Pa/K]
    double heat_of_stretch;  ///< beta_w of the stress work [Pa/K]

    /// s = beta_w^2 T/K [J/(m^3 K)].
    double split_capacity(double temperature) const {
        return heat_of_stretch * heat_of_stretch * temperature / bulk_modulus;
    }
};

double coupling_number(const CoupledSolid& solid, Coupling coupling, double temperature);

/// Where it starts to alternate and grow, whatever the step. Forward Euler meets -g itself: 1. The
/// other scheme takes 2 z - 1 of the last two steps: z^2 + 2 g z - g = 0 has a root of -1 at 1/3.
double coupling_limit(Stepping scheme);

/// Where a single step is lost already. Just beyond its limit bdf2 grows slowly: by a tenth a step
/// at 1.1^2/(1 + 2.2), and a short run stands less.
double coupling_of_a_lost_step(Stepping scheme);

/// "for numerics.coupling = \"lagged\"", and what else the limit hangs on.
std::string coupling_condition(Coupling coupling, Stepping scheme);

/// What helps a solid that is beyond the limit: the keys to set.
std::string coupling_advice(const CoupledSolid& solid, Coupling coupling, Stepping scheme,
                            double temperature);

}  // namespace crawford
