#include "solver/materials/surface_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace crawford {

namespace {

/// An interface this close to a node, in lengths of the segment, goes through it.
constexpr double on_node = 1e-6;

double snapped(double place) {
    if (place < on_node) return 0.0;
    return place > 1.0 - on_node ? 1.0 : place;
}

std::optional<Covered> within_segment(double from, double to) {
    const Covered inside{.from = std::clamp(from, 0.0, 1.0), .to = std::clamp(to, 0.0, 1.0)};
    return inside.to > inside.from ? std::optional(inside) : std::nullopt;
}

}  // namespace

std::optional<Covered> covered_by_disc(const Segment& segment, double radius) {
    const auto& [p, q] = segment;
    const Vector along = q - p;
    const double a = along.squaredNorm();
    const double b = p.dot(along);
    const double discriminant = b * b - a * (p.squaredNorm() - radius * radius);
    if (discriminant <= 0.0) return std::nullopt;
    const double root = std::sqrt(discriminant);
    return within_segment((-b - root) / a, (-b + root) / a);
}

std::optional<Covered> covered_by_strip(const Segment& segment, double half_width) {
    const auto& [p, q] = segment;
    const double along = q.x() - p.x();
    const auto [from, to] =
        std::minmax({(-half_width - p.x()) / along, (half_width - p.x()) / along});
    return within_segment(from, to);
}

namespace {

/// In series: the temperature at a place divides as the resistance does.
void find_temperatures(SegmentPieces& pieces, double fraction, const Conductivities& kappa) {
    const auto resistance = [&](const SurfacePiece& piece) {
        return (piece.to - piece.from) / (piece.fraction == fraction ? kappa.covered : kappa.bare);
    };
    double whole = 0.0;
    for (const SurfacePiece& piece : pieces) whole += resistance(piece);
    double before = 0.0;
    for (SurfacePiece& piece : pieces) {
        piece.right_in_middle = (before + 0.5 * resistance(piece)) / whole;
        before += resistance(piece);
        piece.right_at_end = before / whole;
    }
}

}  // namespace

SegmentPieces pieces_of(std::vector<Covered> covered, double fraction,
                        const Conductivities& conductivity) {
    std::ranges::sort(covered, {}, &Covered::from);
    SegmentPieces pieces;
    const auto add = [&](double to, double what) {
        const double from = pieces.empty() ? 0.0 : pieces.back().to;
        if (!(to > from)) return;
        if (pieces.empty() || pieces.back().fraction != what)
            pieces.push_back({.from = from, .to = to, .fraction = what});
        pieces.back().to = to;
    };
    for (const Covered& part : covered) {
        add(snapped(part.from), 1.0 - fraction);
        add(snapped(part.to), fraction);
    }
    add(1.0, 1.0 - fraction);
    if (pieces.size() > 1) find_temperatures(pieces, fraction, conductivity);
    return pieces;
}

std::vector<PieceShare> shares_of(const SegmentPieces& pieces) {
    const double whole = pieces.front().fraction;
    if (pieces.size() == 1) return {{whole, 0.0, {0.5, 0.0}}, {whole, 1.0, {0.0, 0.5}}};
    std::vector<PieceShare> shares;
    for (const SurfacePiece& piece : pieces) {
        const double half = 0.5 * (piece.to - piece.from);
        shares.push_back({piece.fraction, piece.right_in_middle, {half, half}});
    }
    return shares;
}

}  // namespace crawford
