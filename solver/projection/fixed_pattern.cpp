#include "solver/projection/fixed_pattern.hpp"

#include <algorithm>

namespace crawford {

FixedPattern::FixedPattern(const Grid& grid, const std::vector<bool>& held)
    : grid_(grid), held_(held), matrix_(unknowns(), unknowns()) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int k = 0; k < unknowns(); ++k) entries.emplace_back(k, k, 0.0);
    const auto each_pair = [&](int i, int j, const auto& act) {
        const auto unknown = cell_unknowns(i, j);
        for (size_t p = 0; p < 8; ++p)
            for (size_t q = 0; q <= p; ++q) {
                const int row = std::max(unknown[p], unknown[q]);
                const int column = std::min(unknown[p], unknown[q]);
                act(row, column, !held_[size_t(row)] && !held_[size_t(column)]);
            }
    };
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j)
            each_pair(i, j, [&](int row, int column, bool free) {
                if (free) entries.emplace_back(row, column, 0.0);
            });
    matrix_.setFromTriplets(entries.begin(), entries.end());
    matrix_.makeCompressed();

    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j) {
            auto& slots = slots_.emplace_back();
            size_t next = 0;
            each_pair(i, j, [&](int row, int column, bool free) {
                slots[next++] = free ? slot(row, column) : -1;
            });
        }
}

std::array<int, 8> FixedPattern::cell_unknowns(int i, int j) const {
    std::array<int, 8> result;
    const auto nodes = corners(grid_, i, j);
    for (size_t p = 0; p < 4; ++p)
        for (int component = 0; component < 2; ++component)
            result[2 * p + size_t(component)] = unknown(nodes[p], component);
    return result;
}

int FixedPattern::slot(int row, int column) const {
    const int* first = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column];
    const int* last = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column + 1];
    return int(std::lower_bound(first, last, row) - matrix_.innerIndexPtr());
}

void FixedPattern::clear() {
    std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
    for (int k = 0; k < unknowns(); ++k)
        if (held(k)) matrix_.valuePtr()[slot(k, k)] = 1.0;
}

void FixedPattern::add(int i, int j, const ElementMatrix& k) {
    const auto& slots = slots_[size_t(i) * size_t(grid_.rows()) + size_t(j)];
    const auto unknown = cell_unknowns(i, j);
    size_t next = 0;
    for (int p = 0; p < 8; ++p)
        for (int q = 0; q <= p; ++q) {
            const int target = slots[next++];
            if (target < 0) continue;
            // In a slab a cell has a node on both sides: an entry off the element's diagonal then
            // falls on the matrix's, where both triangles add up.
            const bool folded = p != q && unknown[size_t(p)] == unknown[size_t(q)];
            matrix_.valuePtr()[target] += folded ? 2.0 * k(p, q) : k(p, q);
        }
}

}  // namespace crawford
