/// The velocity that keeps the solid in equilibrium: div(sigma* + dt C:D(v)) + b = 0   (paper eq.
/// 20-24, 40-43).
///
/// Weak form on bilinear elements that follow the surface. The load of the gas enters at every step
/// as a whole, not as an increment, so that errors of equilibrium are corrected and not carried
/// along.
#pragma once

#include <memory>

#include "solver/element/element.hpp"
#include "solver/element/stress_field.hpp"
#include "solver/linear_solvers/spd_solver.hpp"
#include "solver/materials/material_map.hpp"
#include "solver/projection/fixed_pattern.hpp"
#include "solver/projection/patch_centre.hpp"
#include "solver/projection/projection_sources.hpp"

namespace crawford {

class Projection {
public:
    Projection(const Scene& scene, const Grid& grid, const MaterialMap& materials,
               const Checkerboard& checkerboard, const ProjectionSources& sources = {});

    /// Finds the velocity [m/s] at the end of a step of length dt that ends at `time`.
    /// \param stress sigma*, everything of the step but C:D(v); its pressure leaves without
    /// checkerboards
    /// \param velocity the first guess, then the solution
    /// \returns the iterations of the linear solver
    /// \throws NumericalFailure if the linear solver fails
    int solve(StressField& stress, const SurfaceField& surface, double time, double dt,
              NodeVectors& velocity);

    /// |div sigma + b| of the discrete equations, relative to the sum of the magnitudes that should
    /// cancel.
    double residual(const StressField& stress, const NodeVectors& velocity,
                    const SurfaceField& surface, double time) const;

    /// Drops what the linear solver keeps between steps.
    void forget();

    /// tau mu [Pa s] of the Kelvin-Voigt stress 2 tau mu dev D of a cell; zero but in the softer
    /// material.
    double viscosity(int i, int j) const;

private:
    struct Balance {
        Eigen::VectorXd sum;        ///< of the nodal forces [N/m]
        Eigen::VectorXd magnitude;  ///< of what was summed [N/m]

        void add(int unknown, double force) {
            sum[unknown] += force;
            magnitude[unknown] += std::abs(force);
        }
    };

    void assemble(const SurfaceField& surface, double dt);
    void add_cells(const SurfaceField& surface, double dt);
    void add_patches(const SurfaceField& surface, double dt);
    ElementMatrix cell_matrix(const SurfaceField& surface, int i, int j, double dt) const;
    PatchMatrix patch_matrix(const SurfaceField& surface, const Patch& patch, double dt) const;
    int solve_condensed(Eigen::VectorXd force, Eigen::VectorXd& v);
    Eigen::Vector2d at(const Eigen::VectorXd& nodal, const Node& node) const {
        return nodal.segment<2>(matrix_.unknown(node, 0));
    }
    Balance balance(const StressField& stress, const NodeVectors* velocity,
                    const SurfaceField& surface, double time) const;
    void add_stress(Balance& forces, const StressField& stress, const NodeVectors* velocity,
                    const SurfaceField& surface) const;
    void add_traction(Balance& forces, const SurfaceField& surface) const;
    void add_body_force(Balance& forces, const SurfaceField& surface, double time) const;
    void add_traction_source(Balance& forces, const SurfaceField& surface, double time) const;

    const Grid& grid_;
    const MaterialMap& materials_;
    const Checkerboard& checkerboard_;
    SpaceTimeFunction<Vector> body_force_;
    SpaceTimeFunction<Vector> traction_;
    Element element_;
    Surface load_;
    LinearSolver solver_kind_;
    double solver_tolerance_;
    double viscous_time_;
    FixedPattern matrix_;
    Lattice<char> in_patch_;            ///< 1 for a cell that belongs to a patch
    std::vector<PatchCentre> centres_;  ///< of the patches; empty where none is taken out
    std::unique_ptr<SpdSolver> solver_;
};

}  // namespace crawford
