#include "solver/projection/fixed_pattern.hpp"

#include <algorithm>

namespace crawford {

FixedPattern::FixedPattern(const Grid& grid, std::vector<bool> held,
                           const std::vector<Patch>& patches, bool without_centres)
    : grid_(grid), held_(std::move(held)) {
    number(without_centres ? patches : std::vector<Patch>());
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j) append(corners(grid, i, j));
    for (const Patch& patch : patches) append(patch_nodes(grid, patch));
    reserve_pattern();
    find_slots();
}

void FixedPattern::number(const std::vector<Patch>& without_centres) {
    equation_.assign(size_t(unknowns()), 0);
    for (const Patch& patch : without_centres)
        for (int component = 0; component < 2; ++component)
            equation_[size_t(unknown(patch_nodes(grid_, patch)[4], component))] = -1;
    for (int k = 0; k < unknowns(); ++k) {
        if (equation_[size_t(k)] < 0) continue;
        equation_[size_t(k)] = int(with_equation_.size());
        with_equation_.push_back(k);
    }
    matrix_.resize(Eigen::Index(with_equation_.size()), Eigen::Index(with_equation_.size()));
}

template <class Nodes>
void FixedPattern::append(const Nodes& nodes) {
    Block block{0, {}};
    for (const Node& node : nodes)
        for (int component = 0; component < 2; ++component)
            block.unknowns.push_back(unknown(node, component));
    blocks_.push_back(std::move(block));
}

void FixedPattern::reserve_pattern() {
    std::vector<Eigen::Triplet<double>> entries;
    for (int k = 0; k < matrix_.rows(); ++k) entries.emplace_back(k, k, 0.0);
    for (const Block& block : blocks_)
        for (const int row : block.unknowns)
            for (const int column : block.unknowns)
                if (row > column && is_free(row) && is_free(column))
                    entries.emplace_back(equation_[size_t(row)], equation_[size_t(column)], 0.0);
    matrix_.setFromTriplets(entries.begin(), entries.end());
    matrix_.makeCompressed();
}

void FixedPattern::find_slots() {
    for (Block& block : blocks_) {
        block.first = slots_.size();
        const std::vector<int>& u = block.unknowns;
        for (size_t p = 0; p < u.size(); ++p)
            for (size_t q = 0; q <= p; ++q) {
                const int row = std::max(u[p], u[q]);
                const int column = std::min(u[p], u[q]);
                // In a slab a cell has the same node on both sides.
                const bool folded = p != q && row == column;
                const bool free = is_free(row) && is_free(column);
                slots_.push_back(
                    {free ? position(equation_[size_t(row)], equation_[size_t(column)]) : -1,
                     folded ? 2.0 : 1.0});
            }
    }
}

int FixedPattern::position(int row, int column) const {
    const int* first = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column];
    const int* last = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column + 1];
    return int(std::lower_bound(first, last, row) - matrix_.innerIndexPtr());
}

void FixedPattern::clear() {
    std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
    for (int k = 0; k < matrix_.rows(); ++k)
        if (held(with_equation_[size_t(k)])) matrix_.valuePtr()[position(k, k)] = 1.0;
}

}  // namespace crawford
