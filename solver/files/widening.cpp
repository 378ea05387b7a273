#include "solver/files/widening.hpp"

#include <cstdlib>

namespace crawford {

Widening Widening::of_one_column(int columns, double width) {
    return {columns, width, false};
}

Widening Widening::of_right_half(int columns) {
    return {columns, 0.0, true};
}

Widening::Source Widening::node(int i) const {
    if (!by_mirror_) return {0, false};
    return {std::abs(i - columns_ / 2), i < columns_ / 2};
}

Widening::Source Widening::cell(int i) const {
    if (!by_mirror_) return {0, false};
    const int middle = columns_ / 2;
    return i < middle ? Source{middle - 1 - i, true} : Source{i - middle, false};
}

/// \param take (i, j) -> value of the whole
template <class Value, class Take>
Lattice<Value> Widening::widened(const Lattice<Value>& part, int columns, Take take) const {
    if (columns_ == 0 || part.empty()) return part;
    Lattice<Value> whole(columns, part.rows(), part(0, 0));
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < part.rows(); ++j) whole(i, j) = take(i, j);
    return whole;
}

NodeVectors Widening::places(const NodeVectors& part) const {
    return widened(part, columns_ + 1, [&](int i, int j) {
        const Source source = node(i);
        Vector place = part(source.column, j);
        if (source.mirrored) place.x() = -place.x();
        if (!by_mirror_) place.x() += (i - 0.5 * (columns_ - 1)) * width_ / columns_;
        return place;
    });
}

NodeVectors Widening::vectors(const NodeVectors& part) const {
    return widened(part, columns_ + 1, [&](int i, int j) {
        const Source source = node(i);
        const Vector& v = part(source.column, j);
        return source.mirrored ? Vector(-v.x(), v.y()) : v;
    });
}

NodeField Widening::nodes(const NodeField& part) const {
    return widened(part, columns_ + 1, [&](int i, int j) { return part(node(i).column, j); });
}

CellField Widening::cells(const CellField& part) const {
    return widened(part, columns_, [&](int i, int j) { return part(cell(i).column, j); });
}

Snapshot Widening::whole(Snapshot part) const {
    if (columns_ == 0) return part;
    Snapshot whole;
    whole.step = part.step;
    whole.time = part.time;
    whole.position = places(part.position);
    whole.material_indicator = nodes(part.material_indicator);
    whole.temperature = nodes(part.temperature);
    whole.velocity = vectors(part.velocity);
    whole.reference_map = places(part.reference_map);
    whole.material = cells(part.material);
    whole.stress = widened(part.stress, columns_, [&](int i, int j) {
        PlaneStress stress = part.stress(cell(i).column, j);
        if (cell(i).mirrored) stress.s12 = -stress.s12;
        return stress;
    });
    whole.pressure = cells(part.pressure);
    whole.strain = widened(part.strain, columns_, [&](int i, int j) {
        std::array<double, 3> strain = part.strain(cell(i).column, j);
        if (cell(i).mirrored) strain[2] = -strain[2];
        return strain;
    });
    whole.strain_norm = cells(part.strain_norm);
    return whole;
}

}  // namespace crawford
