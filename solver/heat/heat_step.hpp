/// Heat in the burning solid (paper eq. 7, 11, 34, 35):
/// rho c_p DT/Dt = div(kappa grad T) - beta T div v + q.
///
/// Crank-Nicolson in time, or as implicit as the time step says. In space bilinear elements with
/// vertex quadrature on the surface-following cells: second order, the flux through the surface is
/// the natural boundary condition, and the metric cross terms of a sloped surface come with the
/// gradient. On a flat grid it is the five-point stencil, but for cut cells that conduct as
/// laminates.
#pragma once

#include "solver/burning/burn_rate.hpp"
#include "solver/heat/coupling_number.hpp"
#include "solver/heat/heat_sources.hpp"
#include "solver/mesh/node_stencil.hpp"
#include "solver/mesh/solid_motion.hpp"
#include "solver/time_integration/time_step.hpp"

namespace crawford {

/// What the solid does while the heat moves; taken from the last step.
struct HeatMotion : SolidMotion {
    /// DT/Dt [K/s] of the last step; empty unless the stress work is split.
    const CellField& temperature_rate;
};

/// The largest rate at which conduction alone evens out a temperature on this grid [1/s]: that of a
/// zigzag from node to node, 4 D (1/dx^2 + 1/dy^2) in the finest cells.
double stiffest_rate(const Grid& grid, double diffusivity);

/// Crank-Nicolson hardly damps a zigzag in a step that is long for it, and turns its sign at every
/// step: on 512 columns of a sandwich that ends the burn. This is the least share of the new
/// temperature for which a step leaves no more than 0.9 of the stiffest zigzag; it is above one half
/// where the step is more than 38 of its times, and never above 10/19.
double least_implicit(double dt, double stiffest_rate);

class HeatStep {
public:
    HeatStep(const Scene& scene, const Grid& grid, const MaterialMap& materials,
             const BurningLaw& law, const HeatSources& sources = {});

    /// Advances T [K] over the span of a step; the bottom row is held.
    /// \param lagged the temperature where the coefficients of the step are taken
    /// \returns the sweeps of the line relaxation.
    /// \throws NumericalFailure naming the cell where lagged coupling is beyond its limit, the
    /// column if the relaxation does not converge, or the node where T is not above 0 K.
    int advance(NodeField& temperature, const NodeField& lagged, const HeatMotion& motion,
                const TimeStep& step);

    /// The paper's step from `time` over dt.
    int advance(NodeField& temperature, const HeatMotion& motion, double time, double dt) {
        return advance(temperature, temperature, motion, euler_step(time, dt));
    }

    /// Of the last step: the largest coupling number of a cell, zero where nothing deforms.
    double coupling() const { return coupling_; }
    /// Of the last step: what a sweep of the line relaxation left of the error.
    double contraction() const { return contraction_; }

    /// Of the stiffest rate of this grid and its materials.
    double least_implicit(double dt) const { return crawford::least_implicit(dt, stiffest_rate_); }

private:
    void assemble(const NodeField& temperature, const HeatMotion& motion);
    void add_cell(int i, int j, const NodeField& temperature, const HeatMotion& motion);
    void add_stress_work(int i, int j, const std::array<Node, 4>& nodes, double share, double split,
                         const NodeField& temperature, const HeatMotion& motion);
    void add_surface_flux(const NodeField& temperature, const SurfaceField& surface);
    void add_source(const SurfaceField& surface, double time);
    void add_flux_source(const SurfaceField& surface, double time);
    double capacity(int i, int j, double temperature) const;
    double adiabatic_capacity(int i, int j, double temperature) const;
    void check_coupling(int i, int j, double heat_capacity, double temperature);

    const Grid& grid_;
    const MaterialMap& materials_;
    const BurningLaw& law_;
    SpaceTimeFunction<double> source_;
    SpaceTimeFunction<double> flux_source_;
    Numerics numerics_;
    Stepping scheme_;
    bool deforms_;
    double stiffest_rate_;
    double coupling_ = 0.0;
    double contraction_ = 0.0;
    NodeStencil transport_;  ///< diffusion and convection, [W/K] per unit thickness
    NodeField mass_;         ///< lumped heat capacity [J/K]
    NodeField load_;         ///< flux, stress work, source [W]
};

/// Material rate DT/Dt [K/s] of each cell, between two temperatures dt apart, on the moving grid.
void material_rate(const Grid& grid, const NodeField& before, const NodeField& after,
                   const SolidMotion& motion, double dt, CellField& rate);

}  // namespace crawford
