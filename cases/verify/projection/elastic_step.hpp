/// Linear elasticity by the solver: one projection from a stress-free state.
///
/// The stress is zero before the step, so the step makes it C:D(v) dt and the displacement v dt.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reference/truth.hpp"
#include "reports/measurement.hpp"
#include "solver/element/stress_field.hpp"
#include "solver/mesh/grid.hpp"
#include "solver/projection/projection_sources.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

class ElasticStep {
public:
    /// Solves at once.
    /// \param height phi(x) [m] of the surface
    ElasticStep(const Scene& scene, const std::function<double(double x)>& height,
                const ProjectionSources& sources);

    using Where = std::function<bool(double x, double y)>;

    /// Errors of u and v together, at the nodes of `where`, weighted by area.
    void compare_displacement(const std::string& quantity, const reference::Truth& exact,
                              reports::Measurement& to, const Where& where = everywhere) const;

    /// Errors of each component and of the pressure at the cell centres of `where`, one quantity
    /// each: "sigma_11" + suffix, ...; "stress" + suffix for all four components together.
    void compare_stress(const std::string& suffix, const reference::Truth& exact,
                        reports::Measurement& to, const Where& where = everywhere) const;

    const Grid& grid() const { return grid_; }
    const SurfaceField& surface() const { return surface_; }           ///< [m]
    const NodeVectors& displacement() const { return displacement_; }  ///< [m]
    const StressField& stress() const { return stress_; }              ///< [Pa]

    /// |div sigma + b| of the stress carried, relative to what should cancel.
    double residual() const { return residual_; }

    static bool everywhere(double, double) { return true; }

private:
    double node_area(int i, int j) const;

    Grid grid_;
    SurfaceField surface_;
    NodeVectors displacement_;
    StressField stress_;
    double residual_;
};

}  // namespace crawford
