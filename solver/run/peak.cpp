#include "solver/run/peak.hpp"

namespace crawford {

namespace {

Vector centre(const NodeVectors& at, int i, int j) {
    return 0.25 * (at(i, j) + at(i + 1, j) + at(i, j + 1) + at(i + 1, j + 1));
}

double area(const NodeVectors& at, int i, int j) {
    return (at(i + 1, j).x() - at(i, j).x()) * (at(i, j + 1).y() - at(i, j).y());
}

/// Share of a cell that lies within a disc, by sampling: the mean must not jump when a cell's
/// centre crosses the rim.
double share_in_disc(const NodeVectors& at, int i, int j, const Vector& middle, double radius) {
    const Vector along = at(i + 1, j) - at(i, j);
    const Vector up = at(i, j + 1) - at(i, j);
    if ((centre(at, i, j) - middle).norm() > radius + 0.5 * (along.norm() + up.norm())) return 0.0;
    constexpr int samples = 8;
    int inside = 0;
    for (int a = 0; a < samples; ++a)
        for (int b = 0; b < samples; ++b) {
            const Vector point = at(i, j) + (a + 0.5) / samples * along + (b + 0.5) / samples * up;
            if ((point - middle).norm() <= radius) ++inside;
        }
    return double(inside) / (samples * samples);
}

}  // namespace

Peak peak(const NodeVectors& position, const CellField& material, const CellField& field,
          double radius) {
    Peak peak{field(0, 0), 0.0, centre(position, 0, 0)};
    bool in_first_material = true;
    for (int i = 0; i < field.columns(); ++i)
        for (int j = 0; j < field.rows(); ++j) {
            if (field(i, j) < peak.value) continue;
            peak = {field(i, j), 0.0, centre(position, i, j)};
            in_first_material = material(i, j) >= 0.5;
        }

    double sum = 0.0;
    double weight = 0.0;
    for (int i = 0; i < field.columns(); ++i)
        for (int j = 0; j < field.rows(); ++j) {
            if ((material(i, j) >= 0.5) != in_first_material) continue;
            const double covered =
                area(position, i, j) * share_in_disc(position, i, j, peak.place, radius);
            sum += covered * field(i, j);
            weight += covered;
        }
    // A disc that is small beside its cell may hold none of the samples: it lies within the cell.
    peak.mean = weight > 0.0 ? sum / weight : peak.value;
    return peak;
}

}  // namespace crawford
