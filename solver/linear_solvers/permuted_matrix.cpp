#include "solver/linear_solvers/permuted_matrix.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace crawford {

namespace {

/// A value of the permuted matrix and its place among those of the original.
using Entry = std::tuple<int, int, int>;  // column, row, place

std::vector<Entry> permuted_entries(const SparseMatrix& lower, const std::vector<int>& order) {
    std::vector<int> number(order.size());
    for (size_t k = 0; k < order.size(); ++k) number[size_t(order[k])] = int(k);
    std::vector<Entry> entries;
    entries.reserve(size_t(lower.nonZeros()));
    for (int column = 0; column < lower.outerSize(); ++column)
        for (SparseMatrix::InnerIterator at(lower, column); at; ++at) {
            const auto [low, high] = std::minmax(number[size_t(column)], number[size_t(at.row())]);
            entries.emplace_back(low, high, int(&at.value() - lower.valuePtr()));
        }
    std::ranges::sort(entries);
    return entries;
}

}  // namespace

PermutedMatrix::PermutedMatrix(const SparseMatrix& lower, const std::vector<int>& order)
    : order_(Eigen::Map<const Eigen::VectorXi>(order.data(), Eigen::Index(order.size()))),
      permuted_(lower.rows(), lower.cols()) {
    const auto entries = permuted_entries(lower, order);
    std::vector<Eigen::Triplet<double, int>> pattern;
    pattern.reserve(entries.size());
    source_.reserve(entries.size());
    for (const auto& [column, row, place] : entries) {
        pattern.emplace_back(row, column, 0.0);
        source_.push_back(place);
    }
    permuted_.setFromTriplets(pattern.begin(), pattern.end());
}

const SparseMatrix& PermutedMatrix::of(const SparseMatrix& lower) {
    for (size_t k = 0; k < source_.size(); ++k)
        permuted_.valuePtr()[k] = lower.valuePtr()[source_[k]];
    return permuted_;
}

Eigen::VectorXd PermutedMatrix::permuted(const Eigen::VectorXd& x) const {
    return x(order_);
}

Eigen::VectorXd PermutedMatrix::restored(const Eigen::VectorXd& x) const {
    Eigen::VectorXd result(x.size());
    result(order_) = x;
    return result;
}

}  // namespace crawford
