#include "cases/catalogue/sandwich_measures.hpp"

#include <algorithm>

namespace crawford {

namespace {

Vector centre(const Snapshot& snapshot, int i, int j) {
    const auto& at = snapshot.position;
    return 0.25 * (at(i, j) + at(i + 1, j) + at(i, j + 1) + at(i + 1, j + 1));
}

double area(const Snapshot& snapshot, int i, int j) {
    const auto& at = snapshot.position;
    return (at(i + 1, j).x() - at(i, j).x()) * (at(i, j + 1).y() - at(i, j).y());
}

}  // namespace

Peak peak(const Snapshot& snapshot, const CellField& field, double radius) {
    Peak peak{field(0, 0), 0.0, centre(snapshot, 0, 0)};
    for (int i = 0; i < field.columns(); ++i)
        for (int j = 0; j < field.rows(); ++j)
            if (field(i, j) > peak.value) peak = {field(i, j), 0.0, centre(snapshot, i, j)};

    double sum = 0.0;
    double weight = 0.0;
    for (int i = 0; i < field.columns(); ++i)
        for (int j = 0; j < field.rows(); ++j) {
            if ((centre(snapshot, i, j) - peak.place).norm() > radius) continue;
            sum += area(snapshot, i, j) * field(i, j);
            weight += area(snapshot, i, j);
        }
    peak.mean = sum / weight;
    return peak;
}

double largest_outward_displacement(const Snapshot& snapshot) {
    const int top = snapshot.position.rows() - 1;
    double largest = 0.0;
    for (int i = 0; i < snapshot.position.columns(); ++i)
        largest =
            std::max(largest, snapshot.position(i, top).y() - snapshot.reference_map(i, top).y());
    return largest;
}

}  // namespace crawford
