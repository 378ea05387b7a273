/// What enters, leaves and stays in a burning window, summed up from the fields that a simulation
/// shows. The quadrature is this file's own (corners for what is stored, centres for what is
/// carried, trapezoids in time), the table of materials is reference/'s.
#pragma once

#include <vector>

#include "solver/step/simulation.hpp"

namespace crawford {

/// What a window one metre thick holds, and what flows, at one time.
struct Instant {
    double stored = 0.0;             ///< integral of rho c_p (T - T_0) [J]
    double in = 0.0;                 ///< through the surface [W]
    double carried = 0.0;            ///< integral of rho c_p v.grad T [W]
    double work = 0.0;               ///< integral of beta T div v [W]
    double burnt = 0.0;              ///< rho r_b along the surface [kg/s]
    std::vector<double> height;      ///< of the surface at the corners of its segments [m]
    std::vector<double> mass, heat;  ///< what each loses in a metre of regression [kg/m, J/m]
};

/// \pre the mechanics is modelled, and materials are AP and binder in columns.
Instant look(const Simulation& simulation);

/// What has gone through the window since the start.
struct Account {
    double in = 0.0, missing = 0.0;     ///< heat [J]
    double burnt = 0.0, unswept = 0.0;  ///< mass [kg]

    /// A step of dt [s] from one instant to the next, by trapezoids.
    void add(const Instant& a, const Instant& b, double dt);
};

/// Largest difference between p_c times the width and what a row of cells carries, relative.
double force_lost(const Simulation& simulation);

}  // namespace crawford
