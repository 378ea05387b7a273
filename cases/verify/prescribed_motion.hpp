/// A motion that is written down instead of computed: what a study of one of the solver's modules
/// needs around it.
#pragma once

#include <functional>

#include "solver/element/checkerboard.hpp"
#include "solver/stress/stress_step.hpp"

namespace crawford {

/// Functions of the place; one that is not given is zero everywhere.
struct Motion {
    std::function<double(double x)> surface = {};       ///< phi [m]
    std::function<double(double x)> surface_rate = {};  ///< phi_t [m/s]
    std::function<Vector(Vector x)> velocity = {};      ///< of the material [m/s]
};

/// A place inside cell (i, j): integration point `point` of the element, or the centre.
struct CellPoint {
    int i, j, point;
    Vector x;             ///< its place [m]
    double surface_rate;  ///< how fast it rides up with the grid [m/s]
    double weight;        ///< its share of the cell [m^2]
};

/// A body of AP on a grid that follows the prescribed surface.
class PrescribedMotion {
public:
    PrescribedMotion(const Domain& domain, const Motion& motion, Element element = Element::bbar);
    PrescribedMotion(const PrescribedMotion&) = delete;
    PrescribedMotion& operator=(const PrescribedMotion&) = delete;

    const Grid& grid() const { return grid_; }
    const StressStep& stress_step() const { return stress_step_; }
    const SurfaceField& surface() const { return surface_; }
    const NodeVectors& velocity() const { return velocity_; }
    SolidMotion motion() const { return {surface_, surface_rate_, velocity_}; }
    double shear_modulus() const { return materials_.shear_modulus(0, 0); }  ///< [Pa]

    Vector node(int i, int j) const;  ///< its place [m]

    StressField no_stress() const;
    /// Every point that carries a deviator, the points of a cell in their order.
    std::vector<CellPoint> stress_points() const;
    /// The centre of every cell.
    std::vector<CellPoint> centres() const;

private:
    std::vector<CellPoint> points(const std::vector<Local>& of_a_cell) const;

    Scene scene_;
    Grid grid_;
    MaterialMap materials_;
    Checkerboard checkerboard_;
    StressStep stress_step_;
    SurfaceField surface_, surface_rate_;
    NodeVectors velocity_;
};

}  // namespace crawford
