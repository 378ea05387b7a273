/// Which material is where on the grid as it stands, and what a cell that holds two of them is made
/// of.
///
/// The morphology is fixed in the laboratory; the grid follows the surface through it. A cell cut
/// by an interface holds both materials by its volume fraction. Its moduli are harmonic means: two
/// materials in series share a stress, and any mean that keeps a cut cell stiff lets it hold a
/// stress that its softer part cannot carry once it has taken over.
#pragma once

#include "solver/grid/grid.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

class MaterialMap {
public:
    MaterialMap(const Morphology& morphology, const Grid& grid);

    /// Recomputes the fractions for a grid that hangs below `surface`.
    void follow(const SurfaceField& surface);

    /// True where the fractions change as the surface moves.
    bool moves() const;

    /// Volume fraction of the first material in each cell, 0 to 1.
    const CellField& fraction() const { return fraction_; }

    double thermal_conductivity(int i, int j) const;  ///< kappa [W/(m K)]
    double density(int i, int j) const;               ///< rho [kg/m^3]
    double heat_capacity(int i, int j) const;         ///< rho c_p [J/(m^3 K)]
    double bulk_modulus(int i, int j) const;          ///< K [Pa]
    double shear_modulus(int i, int j) const;         ///< mu [Pa]
    double thermal_expansion(int i, int j) const;     ///< alpha [1/K]

    /// beta = 3 alpha K [Pa/K] (paper eq. 38), or alpha K under the other reading.
    double thermal_stress(int i, int j, ThermalStress reading) const;

    /// Cells of different class hold different materials: no stencil reads across.
    bool same_material(int i, int j, int other_i, int other_j) const {
        return (fraction_(i, j) >= 0.5) == (fraction_(other_i, other_j) >= 0.5);
    }

    const Material& first() const { return materials_.front(); }
    const Material& second() const { return materials_.back(); }

private:
    void fill_strip(double width);
    void fill_discs(const Discs& discs, const SurfaceField& surface);
    void add_disc(Vector centre, double radius, const SurfaceField& surface);

    const Grid& grid_;
    Shape shape_;
    std::vector<Material> materials_;
    CellField fraction_;
};

}  // namespace crawford
