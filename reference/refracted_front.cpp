#include "reference/refracted_front.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/require.hpp"

namespace crawford::reference {
namespace {

void require_valid(const InclinedSlab& slab) {
    require_finite("left", slab.left);
    require_finite("right", slab.right);
    require_finite("lean", slab.lean);
    require_positive("slab_rate", slab.slab_rate);
    require_positive("outer_rate", slab.outer_rate);
    if (!(slab.right > slab.left)) throw std::invalid_argument("right must lie above left");
    if (!(slab.width > slab.right - slab.left))
        throw std::invalid_argument("width must exceed right - left");
    const double ratio = slab.outer_rate / slab.slab_rate;
    if (!(ratio > std::hypot(1.0, slab.lean)))
        throw std::invalid_argument(
            fmt::format("outer_rate/slab_rate = {:.4g} must exceed sqrt(1 + lean^2) = {:.4g}",
                        ratio, std::hypot(1.0, slab.lean)));
    const double head_slope = std::sqrt((ratio - 1.0) * (ratio + 1.0));
    if (!(std::abs(slab.lean) * head_slope < 1.0))
        throw std::invalid_argument(fmt::format(
            "lean = {:.4g}: beyond {:.4g} the head wave overhangs", slab.lean, 1.0 / head_slope));
}

}  // namespace

/// In coordinates of the faces, e down along them and n into the slab, Snell keeps the speed along a
/// face: t = (x.e) cos/r_outer + (x.n) sqrt(1/r_slab^2 - (cos/r_outer)^2); the head wave's is
/// r_outer itself, and starts from the right edge.
RefractedFront::RefractedFront(const InclinedSlab& slab)
    : slab_(slab), lean_(std::abs(slab.lean)), cosine_(1.0 / std::hypot(1.0, slab.lean)) {
    require_valid(slab);
    const double sine = lean_ * cosine_;
    const double slow = 1.0 / slab.slab_rate, fast = 1.0 / slab.outer_rate;
    const double along = cosine_ * fast;
    const double through = std::sqrt((slow - along) * (slow + along));
    const double away = std::sqrt((slow - fast) * (slow + fast));
    level_ = {.by_x = 0.0, .by_y = -slow, .start = 0.0};
    refracted_ = {.by_x = cosine_ * through - sine * along,
                  .by_y = -sine * through - cosine_ * along,
                  .start = 0.0};
    head_ = {
        .by_x = -cosine_ * away - sine * fast, .by_y = sine * away - cosine_ * fast, .start = 0};
    head_.start = -head_.by_x * thickness();
    delay_ = cosine_ * thickness() * (through - sine * fast);
}

double RefractedFront::Plane::meets(const Plane& other, double t) const {
    return (other.height(0.0, t) - height(0.0, t)) / (slope() - other.slope());
}

double RefractedFront::alone_until() const {
    if (lean_ == 0.0) return std::numeric_limits<double>::infinity();
    return (slab_.width - thickness()) / (lean_ * slab_.outer_rate);
}

void RefractedFront::require_alone(double t) const {
    require_not_negative("time", t);
    if (!(t < alone_until()))
        throw std::invalid_argument(
            fmt::format("time = {} must be before {} s, when the front comes under the next slab",
                        t, alone_until()));
}

double RefractedFront::faced(double x) const {
    const double faced = slab_.lean < 0.0 ? slab_.right - x : x - slab_.left;
    if (!std::isfinite(slab_.width)) return faced;
    // In (thickness - width, thickness]: a slab, and what it leans over.
    return faced - slab_.width * std::ceil((faced - thickness()) / slab_.width);
}

double RefractedFront::unfaced(double x) const {
    return slab_.lean < 0.0 ? slab_.right - x : slab_.left + x;
}

double RefractedFront::rate(double x, double y) const {
    // Measured at the height y, where the slab has moved by lean y.
    const double place = faced(x - slab_.lean * y);
    const bool inside = place > 0.0 && place < thickness();
    return inside ? slab_.slab_rate : slab_.outer_rate;
}

RefractedFront::Point RefractedFront::in_slab(double x, double t) const {
    Point lowest{level_.height(x, t), level_.slope()};
    for (const Plane* plane : {&refracted_, &head_})
        if (plane->height(x, t) < lowest.height) lowest = {plane->height(x, t), plane->slope()};
    return lowest;
}

RefractedFront::Point RefractedFront::behind(double x, double t) const {
    const double radius = slab_.outer_rate * t, from_edge = x - thickness();
    const double through = -slab_.outer_rate * (t - delay_);
    const double arc = -std::sqrt(std::max((radius - from_edge) * (radius + from_edge), 0.0));
    if (through < arc) return {through, 0.0};
    return {arc, from_edge / -arc};
}

RefractedFront::Point RefractedFront::point(double x, double t) const {
    require_alone(t);
    const double y = -slab_.outer_rate * t;
    if (t == 0.0 || x >= thickness() || x < lean_ * y) return {y, 0.0};
    const Point inside = in_slab(x, t);
    return x <= thickness() + lean_ * inside.height ? inside : behind(x, t);
}

double RefractedFront::height(double x, double t) const {
    return point(faced(x), t).height;
}

double RefractedFront::slope(double x, double t) const {
    return point(faced(x), t).slope * (slab_.lean < 0.0 ? -1.0 : 1.0);
}

/// Down the right face the arc runs at outer_rate, what came through at outer_rate/cosine.
bool RefractedFront::overtaken(double t) const {
    return t - delay_ > t * cosine_;
}

std::vector<double> RefractedFront::crossings(double t) const {
    require_alone(t);
    const double depth = slab_.outer_rate * (overtaken(t) ? t - delay_ : t * cosine_);
    std::vector<double> at{unfaced(-lean_ * slab_.outer_rate * t),
                           unfaced(thickness() - lean_ * depth)};
    std::ranges::sort(at);
    return at;
}

std::vector<double> RefractedFront::kinks(double t) const {
    std::vector<double> at = crossings(t);
    const double first = refracted_.meets(level_, t), last = level_.meets(head_, t);
    if (first < last) {
        at.push_back(unfaced(first));
        at.push_back(unfaced(last));
    } else if (!overtaken(t)) {
        at.push_back(unfaced(refracted_.meets(head_, t)));
    }
    const double radius = slab_.outer_rate * t, lag = slab_.outer_rate * delay_;
    if (overtaken(t)) at.push_back(unfaced(thickness() - std::sqrt(lag * (2.0 * radius - lag))));
    std::ranges::sort(at);
    return at;
}

}  // namespace crawford::reference
