#include "reference/surface_curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crawford::reference {

SurfaceCurve::SurfaceCurve(std::vector<double> ends, const LobattoBasis& basis,
                           Eigen::MatrixXd slopes)
    : ends_(std::move(ends)),
      basis_(basis),
      rule_(basis.degree() + 4),
      slopes_(std::move(slopes)),
      heights_(ends_.size(), 0.0) {
    for (std::size_t k = ends_.size() - 1; k-- > 0;) {
        const auto slope = [&](double x) { return slope_on(k, x); };
        heights_[k] = heights_[k + 1] - integral(ends_[k], ends_[k + 1], slope);
    }
}

template <class Function>
double SurfaceCurve::integral(double from, double to, const Function& f) const {
    const double half = 0.5 * (to - from);
    double sum = 0.0;
    for (Eigen::Index g = 0; g < rule_.points.size(); ++g)
        sum += rule_.weights[g] * half * f(from + half * (rule_.points[g] + 1.0));
    return sum;
}

std::size_t SurfaceCurve::piece(double x) const {
    const auto end = std::lower_bound(ends_.begin() + 1, ends_.end() - 1, x);
    return static_cast<std::size_t>(end - ends_.begin()) - 1;
}

double SurfaceCurve::slope_on(std::size_t piece, double x) const {
    const double xi = 2.0 * (x - ends_[piece]) / (ends_[piece + 1] - ends_[piece]) - 1.0;
    return slopes_.row(static_cast<Eigen::Index>(piece)).dot(basis_.values(xi));
}

double SurfaceCurve::slope(double x) const {
    return slope_on(piece(x), x);
}

double SurfaceCurve::height(double x) const {
    const std::size_t k = piece(x);
    return heights_[k] + integral(ends_[k], x, [&](double at) { return slope_on(k, at); });
}

double SurfaceCurve::length(double from, double to) const {
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < ends_.size(); ++k) {
        if (ends_[k] < from || ends_[k + 1] > to) continue;
        sum += integral(ends_[k], ends_[k + 1],
                        [&](double x) { return std::hypot(1.0, slope_on(k, x)); });
    }
    return sum;
}

}  // namespace crawford::reference
