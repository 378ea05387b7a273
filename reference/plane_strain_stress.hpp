/// The four stresses of plane strain.
#pragma once

namespace crawford::reference {

/// Stress in plane strain [Pa], or a rate of it [Pa/s].
struct PlaneStrainStress {
    double xx, yy, zz, xy;
    double pressure() const { return -(xx + yy + zz) / 3.0; }  ///< [Pa]
};

}  // namespace crawford::reference
