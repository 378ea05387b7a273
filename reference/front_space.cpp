#include "reference/front_space.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "reference/require.hpp"

namespace crawford::reference {
namespace {

double third_of_the_narrower(const SandwichGeometry& geometry) {
    return std::min(geometry.strip, geometry.half_width - geometry.strip) / 3.0;
}

void require_valid(const SandwichGeometry& geometry, const SandwichElements& elements) {
    require_positive("strip", geometry.strip);
    require_positive("half_width", geometry.half_width);
    require_positive("depth", geometry.depth);
    if (geometry.strip >= geometry.half_width)
        throw std::invalid_argument("strip must be narrower than half_width");
    // The paper's sandwich is 12 of this size wide and takes a second and 100 MB; memory grows faster
    // than the number.
    constexpr double most = 120.0;
    if (!(geometry.half_width / third_of_the_narrower(geometry) <= most))
        throw std::invalid_argument(
            "strip and half_width differ too much: the narrower side of the interface must be at "
            "least 1/40 of half_width");
    if (geometry.depth > 1e6 * geometry.half_width)  // layers that double it tell nothing more
        throw std::invalid_argument("depth must be at most a million times half_width");
    if (elements.layers < 1) throw std::invalid_argument("layers must be at least 1");
    if (!(elements.ratio > 0.0 && elements.ratio < 1.0))
        throw std::invalid_argument("ratio must lie between 0 and 1");
}

/// Ascending from 0: layers of `size` that shrink towards 0, then ever longer steps, but none
/// longer than `longest`, to `end`.
std::vector<double> layered(double end, double size, double longest,
                            const SandwichElements& elements) {
    std::vector<double> points = graded(std::min(size, end), 0.0, elements.layers, elements.ratio);
    std::ranges::reverse(points);
    constexpr double growth = 1.5;
    double step = size;
    while (points.back() < end) {
        step = std::min(growth * step, longest);
        const bool last = points.back() + 1.5 * step > end;
        points.push_back(last ? end : points.back() + step);
    }
    return points;
}

}  // namespace

TensorSpace front_space(const SandwichGeometry& geometry, const SandwichElements& elements) {
    require_valid(geometry, elements);
    const auto [inner, outer, strip, half_width, depth] = geometry;
    const double size = third_of_the_narrower(geometry);
    std::vector<double> x;
    for (const double step : layered(strip, size, size, elements))
        x.insert(x.begin(), strip - step);
    const auto right = layered(half_width - strip, size, 2.0 * size, elements);
    for (std::size_t k = 1; k < right.size(); ++k) x.push_back(strip + right[k]);
    x.front() = 0.0;
    x.back() = half_width;
    std::vector<double> y;
    for (const double step : layered(depth, size, depth / 6.0, elements))
        y.insert(y.begin(), -step);
    return {x, y, elements.degree};
}

}  // namespace crawford::reference
