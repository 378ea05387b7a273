/// Which material is where on the grid as it stands, and what a cell that holds two of them is made
/// of.
///
/// The grid follows the surface through a morphology that is fixed in the laboratory, or that the
/// solid carries along: then it stands where the reference map finds it, and a cell is compared
/// with it as the quadrilateral it came from. A cell cut by an interface holds both materials by
/// its volume fraction. How the two conduct
/// together, and how stiff they are together, the scene chooses. As laminates they conduct rightly
/// both along and across the interface. The moduli are harmonic means unless it says otherwise: two
/// materials in series share a stress, and any mean that keeps a cut cell stiff lets it hold a
/// stress that its softer part cannot carry once it has taken over. A laminate's are no two
/// numbers: what carries stress from cell to cell knows a pressure, a deviator and one mu.
#pragma once

#include "solver/materials/carried_grid.hpp"
#include "solver/materials/surface_pieces.hpp"

namespace crawford {

class MaterialMap {
public:
    /// \param numerics says how the materials of a cut cell are averaged
    MaterialMap(Morphology morphology, const Grid& grid, const Numerics& numerics = {});

    /// Recomputes the fractions for a grid that hangs below `surface`.
    /// \param shift xi - (x, y) [m] of each node; ignored where the morphology is fixed in the
    /// laboratory, empty where nothing has moved
    /// \throws NumericalFailure naming a cell that the map turns inside out.
    void follow(const SurfaceField& surface, const NodeVectors& shift = {});

    /// True where the fractions change with time.
    bool moves() const;

    /// Volume fraction of the first material in each cell, 0 to 1.
    const CellField& fraction() const { return fraction_; }

    /// What each segment of the surface burns as: its materials up to where the interface truly
    /// crosses it, or the mean that the cell below it holds.
    const SurfacePieces& surface_pieces() const { return surface_pieces_; }

    /// kappa [W/(m K)]; of a laminate, along the interface.
    double thermal_conductivity(int i, int j) const;
    /// What a laminate's conductivity across the interface differs by, a tensor along the normal
    /// [W/(m K)]; zero but in a cut cell that is read as a laminate.
    Eigen::Matrix2d further_conductivity(int i, int j) const;

    double density(int i, int j) const;        ///< rho [kg/m^3]
    double heat_capacity(int i, int j) const;  ///< rho c_p [J/(m^3 K)]
    double bulk_modulus(int i, int j) const { return bulk_modulus_(i, j); }    ///< K [Pa]
    double shear_modulus(int i, int j) const { return shear_modulus_(i, j); }  ///< mu [Pa]
    const CellField& shear_modulus() const { return shear_modulus_; }          ///< mu [Pa]
    double thermal_expansion(int i, int j) const;                              ///< alpha [1/K]

    /// beta = 3 alpha K [Pa/K] (paper eq. 38), or alpha K under the other reading.
    double thermal_stress(int i, int j, ThermalStress reading) const;

    /// Cells of different class hold different materials: no stencil reads across.
    bool same_material(int i, int j, int other_i, int other_j) const {
        return (fraction_(i, j) >= 0.5) == (fraction_(other_i, other_j) >= 0.5);
    }

    const Material& first() const { return morphology_.materials.front(); }
    const Material& second() const { return morphology_.materials.back(); }

private:
    bool is_carried() const { return morphology_.indicator == Indicator::reference_map; }
    bool is_laminate() const { return conductivity_ == CutConductivity::laminate; }
    double modulus(double fraction, double Material::*property) const;
    void find_moduli();
    void find_normals(const SurfaceField& surface);
    void fill_strip(double width);
    void fill_carried_strip(double width, const CarriedGrid& carried);
    void fill_discs(const Discs& discs, const CarriedGrid& carried);
    void add_disc(Vector centre, double radius, const CarriedGrid& carried);
    template <class Visit>
    void for_discs_in(const Discs& discs, const Vector& low, const Vector& high,
                      const Visit& visit) const;
    double period() const;  ///< of strips, with their mirror images [m]
    void find_surface_pieces(const CarriedGrid& carried);
    SegmentPieces pieces_by_interfaces(int i, const CarriedGrid& carried) const;

    const Grid& grid_;
    Morphology morphology_;
    CutConductivity conductivity_;
    CutModuli moduli_;
    Front front_;
    CellField fraction_;
    SurfacePieces surface_pieces_;
    CellField bulk_modulus_, shear_modulus_;  ///< kept: a stress step reads each some forty times
    NodeVectors normal_;  ///< of the interface in each cell, where cut cells are laminates
};

}  // namespace crawford
