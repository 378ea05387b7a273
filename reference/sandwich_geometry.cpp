#include "reference/sandwich_geometry.hpp"

#include <algorithm>
#include <stdexcept>

#include "reference/require.hpp"

namespace crawford::reference {
namespace {

/// Ascending break points [left, right] from descending ones.
std::vector<double> reversed(std::vector<double> points) {
    std::ranges::reverse(points);
    return points;
}

/// Joins two runs of break points that share an end.
std::vector<double> joined(std::vector<double> first, const std::vector<double>& second) {
    first.insert(first.end(), second.begin() + 1, second.end());
    return first;
}

std::vector<double> uniform(double from, double to, int count) {
    std::vector<double> points;
    for (int i = 0; i <= count; ++i) points.push_back(from + (to - from) * i / count);
    return points;
}

}  // namespace

TensorSpace sandwich_space(const SandwichGeometry& geometry, const SandwichElements& elements) {
    require_positive("strip", geometry.strip);
    require_positive("half_width", geometry.half_width);
    require_positive("depth", geometry.depth);
    if (geometry.strip >= geometry.half_width) {
        throw std::invalid_argument("strip must be narrower than half_width");
    }
    if (elements.layers < 1) throw std::invalid_argument("layers must be at least 1");
    if (!(elements.ratio > 0.0 && elements.ratio < 1.0)) {
        throw std::invalid_argument("ratio must lie between 0 and 1");
    }
    const auto toward = [&](double from, double to) {
        return graded(from, to, elements.layers, elements.ratio);
    };
    const auto x =
        joined(toward(0.0, geometry.strip), reversed(toward(geometry.half_width, geometry.strip)));
    constexpr int middle = 6;  // elements between the graded eighths at top and bottom
    const double eighth = geometry.depth / 8.0;
    const auto lower = joined(reversed(toward(eighth - geometry.depth, -geometry.depth)),
                              uniform(eighth - geometry.depth, -eighth, middle));
    return {x, joined(lower, toward(-eighth, 0.0)), elements.degree};
}

bool in_strip(const SandwichGeometry& geometry, const TensorSpace::Element& element) {
    return element.middle() < geometry.strip;
}

const Material& material_of(const SandwichGeometry& geometry, const TensorSpace::Element& element) {
    return in_strip(geometry, element) ? geometry.inner : geometry.outer;
}

}  // namespace crawford::reference
