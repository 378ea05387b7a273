/// Values on the nodes or the cells of a grid.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace crawford {

/// The zero of a type of values. Eigen's matrices have one by name; Value{} would leave them
/// uninitialised.
template <class Value>
Value zero() {
    if constexpr (requires { Value::Zero(); })
        return Value::Zero();
    else
        return Value{};
}

/// columns x rows values, a column contiguous: column i counts along x, row j upward from the
/// bottom.
template <class Value>
class Lattice {
public:
    Lattice() = default;
    Lattice(int columns, int rows, const Value& initial = zero<Value>())
        : columns_(columns), rows_(rows), values_(size_t(columns) * size_t(rows), initial) {}

    Value& operator()(int i, int j) { return values_[index(i, j)]; }
    const Value& operator()(int i, int j) const { return values_[index(i, j)]; }
    Value* column(int i) { return &values_[index(i, 0)]; }
    const Value* column(int i) const { return &values_[index(i, 0)]; }

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    bool empty() const { return values_.empty(); }
    std::vector<Value>& values() { return values_; }
    const std::vector<Value>& values() const { return values_; }

private:
    size_t index(int i, int j) const { return size_t(i) * size_t(rows_) + size_t(j); }

    int columns_ = 0;
    int rows_ = 0;
    std::vector<Value> values_;
};

using Vector = Eigen::Vector2d;

using NodeField = Lattice<double>;    ///< node columns x (ny + 1)
using NodeVectors = Lattice<Vector>;  ///< node columns x (ny + 1)
using CellField = Lattice<double>;    ///< cell columns x ny

/// One value a node column of the surface: its height phi, or the burn rate there.
using SurfaceField = std::vector<double>;

}  // namespace crawford
