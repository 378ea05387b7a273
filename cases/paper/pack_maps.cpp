#include "cases/paper/pack_maps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "cases/units.hpp"

namespace crawford {

namespace {

using namespace units;

/// The lowest row of cells that a map shows: the first whose upper side reaches above `bottom`.
int first_row(const Snapshot& snapshot, double bottom) {
    const auto& at = snapshot.position;
    int j = 0;
    const auto below = [&](int row) {
        for (int i = 0; i < at.columns(); ++i)
            if (at(i, row).y() > bottom) return false;
        return true;
    };
    while (j + 2 < at.rows() && below(j + 1)) ++j;
    return j;
}

reports::QuadMap corners(const Snapshot& snapshot, int first) {
    const auto& at = snapshot.position;
    reports::QuadMap map{.columns = size_t(at.columns() - 1),
                         .rows = size_t(at.rows() - 1 - first),
                         .x = {"x", "um", {}},
                         .y = {"y", "um", {}},
                         .fields = {}};
    for (int j = first; j < at.rows(); ++j)
        for (int i = 0; i < at.columns(); ++i) {
            map.x.values.push_back(at(i, j).x() / um);
            map.y.values.push_back(at(i, j).y() / um);
        }
    return map;
}

/// By rows, as a map wants them.
std::vector<double> values(const Lattice<double>& field, int first, double scale) {
    std::vector<double> result;
    for (int j = first; j < field.rows(); ++j)
        for (int i = 0; i < field.columns(); ++i) result.push_back(field(i, j) / scale);
    return result;
}

/// Height of the surface at x, straight between its nodes.
double surface_at(const Snapshot& snapshot, double x) {
    const auto& at = snapshot.position;
    const int top = at.rows() - 1, last = at.columns() - 2;
    const double across = (x - at(0, top).x()) / (at(1, top).x() - at(0, top).x());
    const int i = std::clamp(int(across), 0, last);
    return std::lerp(at(i, top).y(), at(i + 1, top).y(), across - i);
}

/// Centres of a disc and its images near the window, `half` wide to either side.
std::vector<Vector> images(const Disc& disc, double half, double period) {
    const double x = disc.x - 2.0 * half * std::round(disc.x / (2.0 * half));
    const double y = disc.y - period * std::ceil(disc.y / period);
    std::vector<Vector> centres;
    for (const double across : {-2.0 * half, 0.0, 2.0 * half})
        for (const double down : {period, 0.0, -period})
            if (std::abs(x + across) < half + disc.radius)
                centres.emplace_back(x + across, y + down);
    return centres;
}

}  // namespace

SurfaceSpan surface_span(const Snapshot& snapshot) {
    const auto& at = snapshot.position;
    const int top = at.rows() - 1;
    SurfaceSpan span{at(0, top).y(), at(0, top).y()};
    for (int i = 0; i < at.columns(); ++i) {
        span.lowest = std::min(span.lowest, at(i, top).y());
        span.highest = std::max(span.highest, at(i, top).y());
    }
    return span;
}

reports::QuadMap node_maps(const Snapshot& snapshot, double bottom) {
    const int first = first_row(snapshot, bottom);
    reports::QuadMap map = corners(snapshot, first);
    map.fields = {{"T", "K", values(snapshot.temperature, first, 1.0)}};
    return map;
}

reports::QuadMap cell_maps(const Snapshot& snapshot, double bottom) {
    const int first = first_row(snapshot, bottom);
    reports::QuadMap map = corners(snapshot, first);
    map.fields = {{"p", "MPa", values(snapshot.pressure, first, MPa)},
                  {"strain norm", "-", values(snapshot.strain_norm, first, 1.0)},
                  {"fraction of AP", "-", values(snapshot.material, first, 1.0)}};
    return map;
}

std::vector<reports::Column> surface_line_of(const Snapshot& snapshot) {
    std::vector<reports::Column> line{{"x", "um", {}}, {"y", "um", {}}};
    const auto& at = snapshot.position;
    for (int i = 0; i < at.columns(); ++i) {
        line[0].values.push_back(at(i, at.rows() - 1).x() / um);
        line[1].values.push_back(at(i, at.rows() - 1).y() / um);
    }
    return line;
}

std::vector<reports::Column> disc_rims(const Scene& scene, const Snapshot& snapshot,
                                       double bottom) {
    constexpr int parts = 180;  // of a rim
    constexpr double lift = std::numeric_limits<double>::quiet_NaN();
    const auto& pack = std::get<Discs>(scene.morphology.shape);
    const double half = 0.5 * scene.domain.width;
    std::vector<double> x, y;
    const auto add = [&](double at_x, double at_y) {
        x.push_back(at_x);
        y.push_back(at_y);
    };
    for (const Disc& disc : pack.discs)
        for (const Vector& centre : images(disc, half, pack.period))
            for (int k = 0; k <= parts; ++k) {
                const double angle = 2.0 * std::numbers::pi * k / parts;
                const Vector p = centre + disc.radius * Vector{std::cos(angle), std::sin(angle)};
                const bool solid = std::abs(p.x()) <= half && p.y() > bottom - disc.radius &&
                                   p.y() < surface_at(snapshot, p.x());
                if (solid) add(p.x() / um, p.y() / um);
                const bool drawing = !x.empty() && !std::isnan(x.back());
                if (drawing && (!solid || k == parts)) add(lift, lift);
            }
    return {{"x", "um", x}, {"y", "um", y}};
}

}  // namespace crawford
