/// Exact solution of phi_t = -r(x, phi) sqrt(1 + phi_x^2), phi = 0 at the start, in a solid with one
/// slab of a slower material between two parallel inclined planes.
///
/// The front is what fastest paths from the level start have just reached: from the faster material
/// into the slab they bend after Snell, out of it they are parallel again; where the slab lies
/// over the faster material, the front starts around its edge as an arc, leads along the
/// interface and draws a head wave through the slab, until what came through the slab overtakes.
#pragma once

#include <limits>
#include <vector>

#include "reference/material.hpp"

namespace crawford::reference {

/// The slab fills left + lean y <= x <= right + lean y.
struct InclinedSlab {
    double left = missing;        ///< [m], where its left face meets y = 0
    double right = missing;       ///< [m]
    double lean = missing;        ///< dx/dy of its faces
    double slab_rate = missing;   ///< r_b [m/s] in the slab, the lower one
    double outer_rate = missing;  ///< r_b [m/s] around it
    /// Period in x [m], of a row of such slabs; infinite for one alone.
    double width = std::numeric_limits<double>::infinity();
};

class RefractedFront {
public:
    /// With n = outer_rate/slab_rate the front is of this kind and single-valued for
    /// sqrt(1 + lean^2) < n, else it goes faster down through the slab than around its edge, and
    /// |lean| sqrt(n^2 - 1) < 1, else the head wave overhangs.
    /// \throws std::invalid_argument naming the parameter that is missing or out of range, or these
    /// limits.
    explicit RefractedFront(const InclinedSlab& slab);

    /// When the front in front of a slab comes under the next of its row [s].
    double alone_until() const;

    double rate(double x, double y) const;  ///< r [m/s] at a place; on a face the larger

    /// phi(x, t) [m].
    /// \throws std::invalid_argument if t [s] is negative or not before alone_until().
    double height(double x, double t) const;
    /// phi_x; at a kink that of one of its sides. \see height
    double slope(double x, double t) const;
    /// Where the front crosses the left and the right face of the slab [m]. \see height
    std::vector<double> crossings(double t) const;
    /// Where the slope jumps [m], ascending: at the crossings; between them until what came
    /// through overtakes at the face; then, behind the slab, where that meets the arc. \see height
    std::vector<double> kinks(double t) const;

private:
    /// A front that is a plane: t = by_x x + by_y y + start.
    struct Plane {
        double by_x, by_y, start;
        double height(double x, double t) const { return (t - start - by_x * x) / by_y; }
        double slope() const { return -by_x / by_y; }
        double meets(const Plane& other, double t) const;
    };
    struct Point {
        double height, slope;
    };

    double thickness() const { return slab_.right - slab_.left; }  // in x
    double faced(double x) const;  // mirrored to lean >= 0, left = 0
    double unfaced(double x) const;
    void require_alone(double t) const;
    bool overtaken(double t) const;  // whether what came through leads at the right face
    Point point(double x, double t) const;
    Point in_slab(double x, double t) const;
    Point behind(double x, double t) const;

    InclinedSlab slab_;
    double lean_, cosine_;            // of the faces, >= 0
    Plane level_, refracted_, head_;  // in the slab
    double delay_ = 0.0;              // of what came through, to what needs not [s]
};

}  // namespace crawford::reference
