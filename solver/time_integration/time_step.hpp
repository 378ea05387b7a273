/// How a step reaches the new time: from a base, over a span, with what is explicit taken at a
/// moment.
#pragma once

namespace crawford {

/// Each equation advances y' = f(y) as  y_new = base + span f(explicit state).
///
///  - euler: base y_n, span dt, explicit state y_n (paper sec. 3.5).
///  - bdf2: base (4 y_n - y_n-1)/3, span 2 dt/3, explicit state 2 y_n - y_n-1 for equal steps; for
///    steps whose lengths have the ratio w the formula of the parabola through all three times
///    (Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, section III.5).
///
/// Both meet the constraint, equilibrium, at the new time. With bdf2 everything stands at the new
/// time, and one solve of the projection still is all that a step takes (Ascher, Ruuth & Wetton
/// 1995).
struct TimeStep {
    double end;            ///< the new time [s]
    double span;           ///< [s]
    double explicit_time;  ///< of the explicit state [s]
    double implicit_heat;  ///< share of the new temperature in conduction and convection

    /// Where conduction and convection, and so the sources of heat, stand [s].
    double heat_time() const { return (1.0 - implicit_heat) * explicit_time + implicit_heat * end; }
};

/// The paper's step from time t over dt: Crank-Nicolson for heat, forward Euler for the rest.
inline TimeStep euler_step(double t, double dt) {
    return {.end = t + dt, .span = dt, .explicit_time = t, .implicit_heat = 0.5};
}

/// The weights of a step that looks back two states, this one `ratio` times as long as the last:
/// base = of_now y_n - of_before y_n-1, span = of_span dt.
struct TwoStepWeights {
    double of_now, of_before, of_span;
};
inline TwoStepWeights bdf2_weights(double ratio) {
    const double whole = 1.0 + 2.0 * ratio;
    return {.of_now = (1.0 + ratio) * (1.0 + ratio) / whole,
            .of_before = ratio * ratio / whole,
            .of_span = (1.0 + ratio) / whole};
}

/// The step of length dt from time t that looks back two states.
inline TimeStep bdf2_step(double t, double dt, double ratio) {
    return {.end = t + dt,
            .span = bdf2_weights(ratio).of_span * dt,
            .explicit_time = t + dt,
            .implicit_heat = 1.0};
}

}  // namespace crawford
