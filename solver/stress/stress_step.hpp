/// Hypoelastic stress (paper eq. 1-5, 18, 19, 39, 44):
/// D(sigma)/Dt + sigma.omega - omega.sigma = C:D - beta (DT/Dt) I + S.
///
/// A step is split around the projection: `predict` takes everything but C:D, `correct` adds C:D of
/// the velocity that the projection found. Advection is WENO3 within one material.
#pragma once

#include <array>

#include "solver/element/checkerboard.hpp"
#include "solver/element/element.hpp"
#include "solver/mesh/solid_motion.hpp"
#include "solver/stress/neighbours.hpp"
#include "solver/stress/stress_sources.hpp"
#include "solver/time_integration/time_step.hpp"

namespace crawford {

class StressStep {
public:
    StressStep(const Scene& scene, const Grid& grid, const MaterialMap& materials,
               const Checkerboard& checkerboard, const StressSources& sources = {});

    /// sigma*: advection, rotation, thermal stress and source over the span of a step (paper
    /// eq. 39).
    /// \param stress the base of the step, then sigma*
    /// \param carried the stress that is carried and turned
    /// \param temperature_rate DT/Dt [K/s] of each cell; empty without heat
    /// \throws NumericalFailure naming the cell, if material crosses more than a cell in the step
    void predict(StressField& stress, const StressField& carried, const SolidMotion& motion,
                 const CellField& temperature_rate, const TimeStep& step) const;

    /// The paper's step from `time` over dt.
    void predict(StressField& stress, const SolidMotion& motion, const CellField& temperature_rate,
                 double time, double dt) const {
        predict(stress, stress, motion, temperature_rate, euler_step(time, dt));
    }

    /// sigma = sigma* + dt C:D(v) on the grid below `surface` (paper eq. 44).
    void correct(StressField& stress, const SurfaceField& surface, const NodeVectors& velocity,
                 double dt) const;

    /// Where an interface has moved into a cell and softened it, its deviator falls in proportion.
    /// \param before shear modulus [Pa] of each cell before the move
    void soften(StressField& stress, const CellField& before) const;

private:
    /// What all the points of a cell share.
    struct Carried {
        int i, j;
        Cell cell;
        std::array<Vector, 4> velocity;  ///< of the corners [m/s]
        std::array<Vector, 4> relative;  ///< the same, seen from the grid
        Reach row, column;
    };

    Carried carried_at(int i, int j, const SolidMotion& motion) const;
    Vector grid_velocity(const Carried& here, Local at) const;
    Deviator deviator_rate(const StressField& stress, int point, const Carried& here,
                           double dt) const;
    double pressure_rate(const CellField& pressure, const Carried& here) const;
    void add_source(StressField& stress, const SurfaceField& surface, double time, double dt) const;

    const Grid& grid_;
    const MaterialMap& materials_;
    const Checkerboard& checkerboard_;
    StressNeighbours neighbours_;
    SpaceTimeFunction<PlaneStress> source_;
    Element element_;
    ThermalStress thermal_stress_;
    bool in_turns_;  ///< its steps are those of heat, several together
};

}  // namespace crawford
