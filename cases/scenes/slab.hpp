/// A homogeneous slab: once a scene for the solver, once conditions for the exact solution.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "reference/slab_conditions.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

///     slab("AP", {.cells = 128})
///         .regressing(0.45 * cm / s)
///         .heated(200 * cal / (s * cm2))
///         .pressed(2 * MPa)
///
/// One periodic column that regresses at a given rate, pyrolysis absorbing nothing, as in the
/// paper's one-dimensional study; or that burns by its law. The two halves share the numbers given
/// here; material properties each takes from its own table.
class Slab {
public:
    struct Grid {
        int cells;
        double clustering = 0.0;
        double depth = 480e-6;  ///< [m]
    };

    /// \param material "AP" or "binder"
    Slab(std::string material, Grid grid);

    Slab& regressing(double burn_rate);  ///< [m/s]
    Slab& burning_by_law();              ///< r_b = A exp(-Ea/(R T_s)), which absorbs q_s rho r_b
    Slab& heated(double flux);           ///< [W/m^2]
    Slab& pressed(double pressure);      ///< [Pa]
    Slab& thermal_stress_alpha_k();      ///< beta = alpha K instead of 3 alpha K
    /// K and mu times n^2, alpha over n: less strain, as much stress work.
    Slab& stiffened(double n);
    Slab& rigid();  ///< no mechanics

    Scene scene() const;
    /// The same slab, of the same finite depth, under the assumptions of `model`.
    reference::SlabConditions conditions(reference::SlabModel model) const;

private:
    std::string material_;
    Grid grid_;
    double burn_rate_ = 0.0;
    double flux_ = 0.0;
    double pressure_ = 0.0;
    double stiffening_ = 1.0;
    bool by_law_ = false;
    bool alpha_k_ = false;
    bool rigid_ = false;
};

Slab slab(const std::string& material, Slab::Grid grid);

/// The steady column, from the bottom up. What the scene does not have is empty.
struct SlabProfile {
    std::vector<double> node_y;  ///< height above the surface, negative [m]
    std::vector<double> node_weight;
    std::vector<double> temperature;  ///< [K]
    std::vector<double> velocity;     ///< [m/s]
    std::vector<double> cell_y;       ///< [m]
    std::vector<double> cell_weight;
    std::vector<double> stress_11;  ///< [Pa]
    std::vector<double> stress_22;  ///< [Pa]
    std::vector<double> pressure;   ///< [Pa]
    std::vector<double> deformation_gradient_22;
    double burn_rate = 0.0;  ///< speed of the surface in the last step [m/s]
};

/// Burns until no temperature and no velocity changes by more than `tolerance` of the largest in a
/// step. The thermal layer relaxes over some 1000 steps, so what is left to go is about 1000 times
/// that: 2e-5 K.
/// \throws NumericalFailure if that takes longer than scene.time.end.
SlabProfile burn_to_steady(const Scene& scene, double tolerance = 2e-11);

}  // namespace crawford
