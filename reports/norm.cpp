#include "reports/norm.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace crawford::reports {
namespace {

using Array = Eigen::ArrayXd;

Array array_of(std::span<const double> values) {
    return Eigen::Map<const Array>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Weights that sum to one. The comparison is written so that a NaN among the weights is refused as
/// well.
Array shares(std::span<const double> weights, std::size_t count) {
    const auto n = static_cast<Eigen::Index>(count);
    if (weights.empty()) return Array::Constant(n, 1.0 / static_cast<double>(count));
    if (weights.size() != count)
        throw std::invalid_argument("norm: weights and values differ in number");
    const Array w = array_of(weights);
    if (!(w >= 0.0).all() || !(w.sum() > 0.0))
        throw std::invalid_argument("norm: weights must not be negative, nor all zero");
    return w / w.sum();
}

double largest(const Array& magnitudes) {
    return magnitudes.isNaN().any() ? std::numeric_limits<double>::quiet_NaN()
                                    : magnitudes.maxCoeff();
}

}  // namespace

std::string_view name(Norm norm) {
    switch (norm) {
        case Norm::L1:
            return "L1";
        case Norm::L2:
            return "L2";
        case Norm::Linf:
            return "Linf";
        case Norm::paper:
            return "eq.55";
        case Norm::magnitude:
            return "|.|";
    }
    throw std::invalid_argument("norm: no such norm");
}

Norm norm_named(std::string_view word) {
    for (const Norm norm : {Norm::L1, Norm::L2, Norm::Linf, Norm::paper, Norm::magnitude})
        if (name(norm) == word) return norm;
    throw std::invalid_argument(std::string(word) + " is no norm");
}

double norm(Norm norm, std::span<const double> values, std::span<const double> weights) {
    if (values.empty()) throw std::invalid_argument("norm: no values");
    const Array e = array_of(values).abs();
    const Array w =
        shares(norm == Norm::paper ? std::span<const double>{} : weights, values.size());
    switch (norm) {
        case Norm::L1:
            return (w * e).sum();
        case Norm::L2:
        case Norm::paper:
            return std::sqrt((w * e.square()).sum());
        case Norm::Linf:
            return largest(e);
        case Norm::magnitude:
            if (values.size() != 1)
                throw std::invalid_argument("norm: magnitude is of a single number");
            return e[0];
    }
    throw std::invalid_argument("norm: no such norm");
}

double distance(Norm norm, std::span<const double> values, std::span<const double> truth,
                std::span<const double> weights) {
    if (values.size() != truth.size())
        throw std::invalid_argument("distance: values and truth differ in number");
    const Array difference = array_of(values) - array_of(truth);
    return reports::norm(norm, {difference.data(), values.size()}, weights);
}

}  // namespace crawford::reports
