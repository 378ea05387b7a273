#include "solver/burning/surface_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "solver/mesh/weno.hpp"

namespace crawford {

namespace {

// Slopes are of order one: a change of slope of 1e-3 between neighbours is smooth.
constexpr double smooth_slope_squared = 1e-6;

// Where AP comes out under binder the surface is a cliff. A height over columns cannot hold one: a
// node that it sweeps would fall without bound, and faster on finer grids. It falls as on this slope.
constexpr double steepest_held = 4.0;

/// A segment as it is met from left to right.
struct Stretch {
    double slope;
    double width;        ///< [m]
    double left, right;  ///< fraction of the first material at its two ends
    bool whole() const { return left == right; }
};

/// One-sided slopes within the material of each side; none where that side is cut by an interface.
struct OwnSlopes {
    std::optional<double> left, right;
};

class MovingSurface {
public:
    MovingSurface(const Grid& grid, const SurfaceField& surface, const SurfacePieces& pieces,
                  const RateOfMaterial& rate)
        : grid_(grid), surface_(surface), pieces_(pieces), rate_(rate) {}

    SurfaceField rate(const std::vector<Vector>& material_velocity, double dt) const {
        SurfaceField fall(surface_.size());
        SurfaceField carried(surface_.size(), 0.0);
        for (int i = 0; i < grid_.node_columns(); ++i) {
            const OwnSlopes slopes = own_slopes(i);
            fall[size_t(i)] = std::max(fall_from_left(i, slopes), fall_from_right(i, slopes));
            if (!material_velocity.empty())
                carried[size_t(i)] = carried_rate(material_velocity[size_t(i)], slopes);
        }
        for_pieces_without_node([&](int i, double r) { raise(fall[size_t(i)], r); });
        SurfaceField rate(surface_.size());
        for (size_t i = 0; i < rate.size(); ++i) rate[i] = carried[i] - fall[i];
        for (int i = 0; i < grid_.cell_columns(); ++i)
            if (!stretch(i).whole()) drag(i, fall, carried, dt, rate);
        return rate;
    }

    SurfaceField faster_rate() const {
        SurfaceField faster(size_t(grid_.node_columns()));
        for (int i = 0; i < grid_.node_columns(); ++i)
            faster[size_t(i)] =
                std::max(rate_at(stretch(i - 1).right, i), rate_at(stretch(i).left, i));
        for_pieces_without_node([&](int i, double r) { raise(faster[size_t(i)], r); });
        return faster;
    }

private:
    static void raise(double& value, double other) { value = std::max(value, other); }

    /// The segment over cell column i, which may lie beyond the sides.
    Stretch stretch(int i) const {
        const int n = grid_.cell_columns();
        if (grid_.sides() == Sides::periodic) return inside((i + 2 * n) % n);
        if (i >= 0 && i < n) return inside(i);
        const Stretch mirrored = inside(std::clamp(i < 0 ? -1 - i : 2 * n - 1 - i, 0, n - 1));
        return {-mirrored.slope, mirrored.width, mirrored.right, mirrored.left};
    }

    Stretch inside(int i) const {
        const SegmentPieces& pieces = pieces_[size_t(i)];
        return {grid_.slope(surface_, i), grid_.dx(i), pieces.front().fraction,
                pieces.back().fraction};
    }

    /// The WENO derivative at a node where columns are `metric` apart, by differences per column
    /// that end where the material does: beyond it one is repeated from upwind, or goes on as a line
    /// downwind.
    static std::optional<double> upwind_slope(const Stretch& far, const Stretch& near,
                                              const Stretch& ahead, bool far_joins,
                                              bool ahead_joins, double metric) {
        if (!near.whole()) return std::nullopt;
        const auto rise = [&](const Stretch& s) { return s.slope * (s.width / metric); };
        const double behind = far_joins && far.whole() ? rise(far) : rise(near);
        const double before =
            ahead_joins && ahead.whole() ? rise(ahead) : 2.0 * rise(near) - behind;
        return weno3({behind, rise(near), before}, smooth_slope_squared);
    }

    OwnSlopes own_slopes(int i) const {
        const Stretch a = stretch(i - 2), b = stretch(i - 1), c = stretch(i), d = stretch(i + 1);
        const bool through = b.right == c.left;
        const double metric = grid_.metric_x(i);
        return {upwind_slope(a, b, c, a.right == b.left, through, metric),
                upwind_slope(d, c, b, c.right == d.left, through, metric)};
    }

    /// Godunov: sqrt(1 + p^2) grows with |p|, so a side takes its slope where it runs into the node.
    double fall_from_left(int i, const OwnSlopes& slopes) const {
        return rate_at(stretch(i - 1).right, i) * std::hypot(1.0, running_right(slopes));
    }
    double fall_from_right(int i, const OwnSlopes& slopes) const {
        return rate_at(stretch(i).left, i) * std::hypot(1.0, running_left(slopes));
    }
    static double running_right(const OwnSlopes& slopes) {
        return std::clamp(slopes.left.value_or(0.0), 0.0, steepest_held);
    }
    static double running_left(const OwnSlopes& slopes) {
        return std::clamp(-slopes.right.value_or(0.0), 0.0, steepest_held);
    }

    static double carried_rate(const Vector& v, const OwnSlopes& slopes) {
        const auto& upwind = v.x() > 0.0 ? slopes.left : slopes.right;
        const auto& other = v.x() > 0.0 ? slopes.right : slopes.left;
        return v.y() - v.x() * upwind.value_or(other.value_or(0.0));
    }

    /// Pieces between two interfaces in one segment belong to the nearer of its nodes.
    template <class Visit>
    void for_pieces_without_node(const Visit& visit) const {
        for (int i = 0; i < grid_.cell_columns(); ++i)
            for (const SurfacePiece& piece : pieces_[size_t(i)]) {
                if (piece.from == 0.0 || piece.to == 1.0) continue;
                const int right = grid_.right_node(i);
                visit(piece.from + piece.to > 1.0 ? right : i,
                      rate_(piece.fraction, {i, right, piece.right_in_middle}));
            }
    }

    double rate_at(double fraction, int i) const { return rate_(fraction, {i, i, 0.0}); }

    /// A side of an interface that crosses a segment: its first node and how it comes to the
    /// crossing from there.
    struct Side {
        int node;
        double fraction;  ///< of the first material
        double distance;  ///< of the crossing from the node [m]
        double slope;     ///< of its surface, from the node towards the crossing
        double height;    ///< of the crossing, on the line of that slope [m]
        double fall;      ///< of the crossing, were it for this side alone [m/s]
    };

    std::array<Side, 2> sides(int i) const {
        const SegmentPieces& pieces = pieces_[size_t(i)];
        const double crossing = 0.5 * (pieces.front().to + pieces.back().from);
        const double of_right = pieces.front().right_at_end;
        const int right = grid_.right_node(i);
        const auto side = [&](int node, double fraction, double distance, double slope,
                              double of_node) {
            const SurfacePlace place{i, right, 0.5 * (of_right + of_node)};
            return Side{
                node,
                fraction,
                distance,
                slope,
                surface_[size_t(node)] + distance * slope,
                rate_(fraction, place) * std::hypot(1.0, std::clamp(slope, 0.0, steepest_held))};
        };
        return {side(i, pieces.front().fraction, crossing * grid_.dx(i),
                     own_slopes(i).left.value_or(0.0), 0.0),
                side(right, pieces.back().fraction, (1.0 - crossing) * grid_.dx(i),
                     -own_slopes(right).right.value_or(0.0), 1.0)};
    }

    /// Where segment i changes material, the side that falls faster leads and drags the other.
    void drag(int i, const SurfaceField& fall, const SurfaceField& carried, double dt,
              SurfaceField& rate) const {
        const auto [left, right] = sides(i);
        const bool from_left = left.fall > right.fall;
        const Side& leader = from_left ? left : right;
        const Side& other = from_left ? right : left;
        const auto lead = size_t(leader.node), dragged = size_t(other.node);
        const double speed = std::max(fall[lead], leader.fall);
        rate[lead] = std::min(rate[lead], carried[lead] - speed);

        const auto slope = dragged_slope(speed, rate_at(other.fraction, other.node));
        if (!slope) return;
        const double plane = leader.height - speed * dt + other.distance * *slope;
        // Under a face that leans over it the leader comes out at the foot of a cliff. No node falls
        // faster than a slope of this height swept along at the leader's speed.
        const double fastest =
            speed * (1.0 + std::min(std::abs(grid_.slope(surface_, i)), steepest_held));
        const double falls = std::min((surface_[dragged] - plane) / dt, fastest);
        rate[dragged] = std::min(rate[dragged], carried[lead] - falls);
    }

    /// Slope of the plane that a crossing which sinks at v draws behind it through material that
    /// burns at r: v = r sqrt(1 + p^2); none where that burns as fast by itself.
    static std::optional<double> dragged_slope(double v, double r) {
        if (v <= r) return std::nullopt;
        return std::sqrt((v / r) * (v / r) - 1.0);
    }

    const Grid& grid_;
    const SurfaceField& surface_;
    const SurfacePieces& pieces_;
    const RateOfMaterial& rate_;
};

}  // namespace

SurfaceField surface_rate(const Grid& grid, const SurfaceField& surface,
                          const SurfacePieces& pieces, const RateOfMaterial& rate,
                          const std::vector<Vector>& material_velocity, double dt) {
    return MovingSurface(grid, surface, pieces, rate).rate(material_velocity, dt);
}

SurfaceField surface_rate(const Grid& grid, const SurfaceField& surface,
                          const SurfaceField& burn_rate,
                          const std::vector<Vector>& material_velocity) {
    const SurfacePieces whole(size_t(grid.cell_columns()), {{0.0, 1.0, 1.0}});
    const RateOfMaterial rate = [&](double, const SurfacePlace& node) {
        return burn_rate[size_t(node.left)];
    };
    return MovingSurface(grid, surface, whole, rate).rate(material_velocity, 0.0);
}

SurfaceField faster_rate(const Grid& grid, const SurfacePieces& pieces,
                         const RateOfMaterial& rate) {
    const SurfaceField level(size_t(grid.node_columns()), 0.0);
    return MovingSurface(grid, level, pieces, rate).faster_rate();
}

double mean_over_pieces(const Grid& grid, const SurfaceField& surface, const SurfacePieces& pieces,
                        const RateOfMaterial& rate) {
    double burnt = 0.0;
    double length = 0.0;
    for (int i = 0; i < grid.cell_columns(); ++i) {
        const double segment = grid.dx(i) * std::hypot(1.0, grid.slope(surface, i));
        for (const PieceShare& piece : shares_of(pieces[size_t(i)]))
            burnt += segment * (piece.of_node[0] + piece.of_node[1]) *
                     rate(piece.fraction, {i, grid.right_node(i), piece.right});
        length += segment;
    }
    return burnt / length;
}

}  // namespace crawford
