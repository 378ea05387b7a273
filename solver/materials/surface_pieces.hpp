/// What the burning surface is made of, piece by piece, up to where interfaces truly cross it.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "solver/mesh/lattice.hpp"

namespace crawford {

/// A stretch of one segment of the surface, the straight line between two node columns.
struct SurfacePiece {
    double from, to;  ///< 0 at the segment's left node, 1 at its right one
    double fraction;  ///< of the first material in it: 0 or 1 unless it stands for a mean

    /// How much of the temperature in the middle and at the end is that of the right node; the rest
    /// is that of the left one. The pieces conduct in series, so it is no straight line.
    double right_in_middle = 0.5, right_at_end = 1.0;
};

/// The pieces of one segment, from left to right; together they are the whole of it.
using SegmentPieces = std::vector<SurfacePiece>;

/// Of every segment; segment i lies over cell column i.
using SurfacePieces = std::vector<SegmentPieces>;

/// The part of a segment that something covers.
struct Covered {
    double from, to;
};

/// Its two ends [m].
using Segment = std::array<Vector, 2>;

/// What a disc about the origin covers of a segment; nothing where it misses or only touches it.
std::optional<Covered> covered_by_disc(const Segment& segment, double radius);
/// What the strip |x| <= half_width covers of it.
std::optional<Covered> covered_by_strip(const Segment& segment, double half_width);

/// Thermal conductivities [W/(m K)] of what is covered and of what is not.
struct Conductivities {
    double covered, bare;
};

/// The pieces of a segment whose fraction of the first material is `fraction` where it is covered
/// and 1 - fraction elsewhere. Pieces too short to be more than round-off are left out.
SegmentPieces pieces_of(std::vector<Covered> covered, double fraction,
                        const Conductivities& conductivity);

/// What a piece, or half of a whole segment, gives to the integral of a flux over the segment.
struct PieceShare {
    double fraction;                ///< of the first material
    double right;                   ///< of its temperature, how much is that of the right node
    std::array<double, 2> of_node;  ///< of the segment's length, what of it goes to the left and to
                                    ///< the right node
};

/// The shares of a segment; a whole one is lumped at its two nodes. The cell below a cut one is one
/// mean of its materials from side to side, so the nodes share all of its pieces alike: else heat
/// along an interface would not go straight.
std::vector<PieceShare> shares_of(const SegmentPieces& pieces);

}  // namespace crawford
