#include "cases/verify/reference_map/followed_motion.hpp"

#include <cmath>
#include <numbers>

#include "cases/verify/comparison.hpp"
#include "solver/reference_map/reference_map.hpp"

namespace crawford {

namespace wavy_square {

namespace {

constexpr double wave_number = 2.0 * std::numbers::pi / width;

}  // namespace

double surface(double x) {
    return 0.05 * width * std::cos(wave_number * x);
}

double surface_rate(double x) {
    return -burn_rate * (1.0 + 0.3 * std::sin(wave_number * x));
}

PrescribedMotion body(const FollowedMotion& motion, int cells) {
    return {{.width = width, .depth = width, .nx = cells, .ny = cells, .clustering = 1.0},
            {.surface = surface, .surface_rate = surface_rate, .velocity = motion.velocity}};
}

bool is_inside(const Vector& x) {
    return std::abs(x.x()) < 0.4 * width;
}

}  // namespace wavy_square

NodeVectors shift_of(const PrescribedMotion& body, const FollowedMotion& motion) {
    NodeVectors shift(body.grid().node_columns(), body.grid().rows() + 1);
    for (int i = 0; i < shift.columns(); ++i)
        for (int j = 0; j < shift.rows(); ++j) {
            const Vector x = body.node(i, j);
            shift(i, j) = motion.origin(x) - x;
        }
    return shift;
}

void report_gradients(const PrescribedMotion& body, const NodeVectors& shift,
                      const FollowedMotion& motion, reports::Measurement& to) {
    const auto found = deformation_gradient(body.grid(), body.surface(), shift);
    Comparison f, e;
    for (const CellPoint& at : body.centres()) {
        if (!wavy_square::is_inside(at.x)) continue;
        f.add(found(at.i, at.j), motion.gradient(at.x), at.weight);
        e.add(green_strain(found(at.i, at.j)), motion.strain(at.x), at.weight);
    }
    f.report("F", to);
    e.report("E", to);
    to.value(worst_f, reports::distance(reports::Norm::Linf, f.found, f.exact))
        .value(worst_e, reports::distance(reports::Norm::Linf, e.found, e.exact));
}

}  // namespace crawford
