#include "cases/verify/prescribed_motion.hpp"

namespace crawford {

namespace {

Scene body(const Domain& domain, Element element) {
    Scene scene;
    scene.domain = domain;
    scene.numerics.element = element;
    return scene;
}

}  // namespace

PrescribedMotion::PrescribedMotion(const Domain& domain, const Motion& motion, Element element)
    : scene_(body(domain, element)),
      grid_(domain),
      materials_(scene_.morphology, grid_),
      checkerboard_(grid_, materials_, element),
      stress_step_(scene_, grid_, materials_, checkerboard_),
      surface_(size_t(grid_.node_columns()), 0.0),
      surface_rate_(surface_),
      velocity_(grid_.node_columns(), grid_.rows() + 1) {
    for (int i = 0; i < grid_.node_columns(); ++i) {
        if (motion.surface) surface_[size_t(i)] = motion.surface(grid_.x(i));
        if (motion.surface_rate) surface_rate_[size_t(i)] = motion.surface_rate(grid_.x(i));
        for (int j = 0; motion.velocity && j <= grid_.rows(); ++j)
            velocity_(i, j) = motion.velocity(node(i, j));
    }
}

Vector PrescribedMotion::node(int i, int j) const {
    return {grid_.x(i), surface_[size_t(i)] + grid_.eta(j)};
}

StressField PrescribedMotion::no_stress() const {
    const auto points = crawford::stress_points(scene_.numerics.element).size();
    return {grid_.cell_columns(), grid_.rows(), int(points)};
}

std::vector<CellPoint> PrescribedMotion::stress_points() const {
    return points(crawford::stress_points(scene_.numerics.element));
}

std::vector<CellPoint> PrescribedMotion::centres() const {
    return points({cell_centre});
}

std::vector<CellPoint> PrescribedMotion::points(const std::vector<Local>& of_a_cell) const {
    std::vector<CellPoint> result;
    for (int i = 0; i < grid_.cell_columns(); ++i)
        for (int j = 0; j < grid_.rows(); ++j)
            for (size_t k = 0; k < of_a_cell.size(); ++k) {
                const Local at = of_a_cell[k];
                const auto between = [&](const SurfaceField& f) {
                    return (1.0 - at.a) * f[size_t(i)] + at.a * f[size_t(grid_.right_node(i))];
                };
                const double eta = grid_.eta(j) + at.b * grid_.height(j);
                result.push_back(
                    {.i = i,
                     .j = j,
                     .point = int(k),
                     .x = {grid_.x(i) + at.a * grid_.dx(i), between(surface_) + eta},
                     .surface_rate = between(surface_rate_),
                     .weight = grid_.dx(i) * grid_.height(j) / double(of_a_cell.size())});
            }
    return result;
}

}  // namespace crawford
