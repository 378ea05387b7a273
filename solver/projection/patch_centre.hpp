/// The node in the middle of a patch, taken out of the equations before they are solved.
///
/// It couples with the eight nodes around it and with nothing else, so it can be eliminated patch by
/// patch (static condensation; Wilson, Int. J. Numer. Meth. Engng 8, 1974): a quarter of the
/// unknowns less. With c the middle and o the nodes around,
///     v_c = D^-1 f_c - W v_o,   f_o' = f_o - W^T f_c,   K_oo' = K_oo - K_oc W,   W = D^-1 K_co.
#pragma once

#include <Eigen/Core>

namespace crawford {

/// Of the nine nodes of a patch: (node 0 x, node 0 y, node 1 x, ...).
using PatchMatrix = Eigen::Matrix<double, 18, 18>;
using PatchVector = Eigen::Matrix<double, 18, 1>;

class PatchCentre {
public:
    static constexpr int first = 8;  ///< of its two rows in a PatchMatrix

    PatchCentre() = default;
    /// Takes the middle out of `k`; its rows and columns are left zero.
    explicit PatchCentre(PatchMatrix& k);

    /// What the force on the middle is on the nodes around it; zero at the middle.
    PatchVector spread(const Eigen::Vector2d& force) const;
    /// The middle's velocity. \param around velocities of the patch; the middle's is not read.
    Eigen::Vector2d velocity(const Eigen::Vector2d& force, const PatchVector& around) const;

private:
    Eigen::Matrix2d inverse_ = Eigen::Matrix2d::Zero();                          ///< D^-1
    Eigen::Matrix<double, 2, 18> lever_ = Eigen::Matrix<double, 2, 18>::Zero();  ///< W
};

}  // namespace crawford
