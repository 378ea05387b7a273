#include "solver/projection/patch_centre.hpp"

#include <Eigen/LU>

namespace crawford {

PatchCentre::PatchCentre(PatchMatrix& k) {
    const Eigen::Matrix2d middle = k.block<2, 2>(first, first);
    inverse_ = middle.inverse();
    Eigen::Matrix<double, 2, 18> coupling = k.middleRows<2>(first);
    coupling.middleCols<2>(first).setZero();
    lever_ = inverse_ * coupling;
    k.noalias() -= coupling.transpose() * lever_;
    k.middleRows<2>(first).setZero();
    k.middleCols<2>(first).setZero();
}

PatchVector PatchCentre::spread(const Eigen::Vector2d& force) const {
    return -lever_.transpose() * force;
}

Eigen::Vector2d PatchCentre::velocity(const Eigen::Vector2d& force,
                                      const PatchVector& around) const {
    return inverse_ * force - lever_ * around;
}

}  // namespace crawford
