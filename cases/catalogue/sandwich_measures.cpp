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

/// Share of a cell that lies within a disc, by sampling: the mean must not jump when a cell's
/// centre crosses the rim.
double share_in_disc(const Snapshot& snapshot, int i, int j, const Vector& middle, double radius) {
    constexpr int samples = 8;
    const auto& at = snapshot.position;
    const Vector along = at(i + 1, j) - at(i, j);
    const Vector up = at(i, j + 1) - at(i, j);
    int inside = 0;
    for (int a = 0; a < samples; ++a)
        for (int b = 0; b < samples; ++b) {
            const Vector point = at(i, j) + (a + 0.5) / samples * along + (b + 0.5) / samples * up;
            if ((point - middle).norm() <= radius) ++inside;
        }
    return double(inside) / (samples * samples);
}

}  // namespace

Peak peak(const Snapshot& snapshot, const CellField& field, double radius) {
    Peak peak{field(0, 0), 0.0, centre(snapshot, 0, 0)};
    bool in_first_material = true;
    for (int i = 0; i < field.columns(); ++i)
        for (int j = 0; j < field.rows(); ++j) {
            if (field(i, j) < peak.value) continue;
            peak = {field(i, j), 0.0, centre(snapshot, i, j)};
            in_first_material = snapshot.material(i, j) >= 0.5;
        }

    double sum = 0.0;
    double weight = 0.0;
    for (int i = 0; i < field.columns(); ++i)
        for (int j = 0; j < field.rows(); ++j) {
            if ((snapshot.material(i, j) >= 0.5) != in_first_material) continue;
            const double covered =
                area(snapshot, i, j) * share_in_disc(snapshot, i, j, peak.place, radius);
            sum += covered * field(i, j);
            weight += covered;
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
