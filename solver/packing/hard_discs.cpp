#include "solver/packing/hard_discs.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>

namespace crawford {

static_assert(FLT_EVAL_METHOD == 0, "packs repeat only where doubles are computed as doubles");

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// What takes one of two points in the box, `distance` apart, to its image nearest to the other.
double shift_to_nearest(double distance, double period) {
    if (distance > 0.5 * period) return -period;
    return distance < -0.5 * period ? period : 0.0;
}

double wrapped(double x, double period) {
    return x - period * std::floor(x / period);
}

}  // namespace

HardDiscs::HardDiscs(const Box& box, std::vector<HardDisc> discs, double size)
    : box_(box),
      discs_(std::move(discs)),
      size_(size),
      // A quarter of a disc's share of the box: the lists stay short and last for some collisions.
      // A quarter of the box: then three images each way are all that can be met.
      margin_(0.25 *
              std::min({std::sqrt(box.width * box.height / static_cast<double>(discs_.size())),
                        box.width, box.height})) {}

double HardDiscs::energy() const {
    double energy = 0.0;
    for (const HardDisc& d : discs_) energy += 0.5 * d.mass * (d.u * d.u + d.v * d.v);
    return energy;
}

void HardDiscs::set_energy(double wanted) {
    const double now = energy();
    if (now == 0.0) return;
    const double factor = std::sqrt(wanted / now);
    for (HardDisc& d : discs_) {
        d.u *= factor;
        d.v *= factor;
    }
}

long HardDiscs::advance(double growth, double duration, long most) {
    if (growth == 0.0 && energy() == 0.0) return 0;
    growth_ = growth;
    long collisions = 0;
    while (collisions < most && duration > 0.0) {
        list_pairs(growth == 0.0 ? size_ : size_ + growth * duration);
        predict_all();
        collisions += run(duration, most - collisions);
        duration -= clock_;
    }
    return collisions;
}

long HardDiscs::run(double end, long most) {
    long collisions = 0;
    while (collisions < most) {
        const std::size_t event = events_.next();
        const double time = std::min(events_.time(event), end);
        drift(std::max(0.0, time - clock_));
        clock_ = time;
        if (time == end || event >= pairs_.size()) break;
        const Pair pair = pairs_[event];
        collide(pair);
        predict(pair.first);
        predict(pair.second);
        ++collisions;
    }
    return collisions;
}

void HardDiscs::drift(double duration) {
    size_ += growth_ * duration;
    for (HardDisc& d : discs_) {
        d.x += d.u * duration;
        d.y += d.v * duration;
    }
}

void HardDiscs::collide(const Pair& pair) {
    HardDisc& a = discs_[pair.first];
    HardDisc& b = discs_[pair.second];
    const Approach contact = approach(pair);
    const double push =
        impulse(contact, a.mass, b.mass) / std::sqrt(contact.x * contact.x + contact.y * contact.y);
    a.u -= push * contact.x / a.mass;
    a.v -= push * contact.y / a.mass;
    b.u += push * contact.x / b.mass;
    b.v += push * contact.y / b.mass;
}

Approach HardDiscs::approach(const Pair& pair) const {
    const HardDisc& a = discs_[pair.first];
    const HardDisc& b = discs_[pair.second];
    const double radii = a.radius + b.radius;
    return {.x = b.x + pair.shift_x - a.x,
            .y = b.y + pair.shift_y - a.y,
            .u = b.u - a.u,
            .v = b.v - a.v,
            .reach = radii * size_,
            .growth = radii * growth_};
}

double HardDiscs::time_to_escape(std::size_t disc) const {
    const HardDisc& d = discs_[disc];
    const double speed2 = d.u * d.u + d.v * d.v;
    if (speed2 == 0.0) return never;
    const double x = d.x - start_[disc].x;
    const double y = d.y - start_[disc].y;
    const double outward = x * d.u + y * d.v;
    const double left = std::max(0.0, margin_ * margin_ - x * x - y * y);
    return (std::sqrt(outward * outward + speed2 * left) - outward) / speed2;
}

void HardDiscs::predict_all() {
    clock_ = 0.0;
    events_.reset(pairs_.size() + discs_.size());
    for (std::size_t i = 0; i < discs_.size(); ++i) predict(i);
}

void HardDiscs::predict(std::size_t disc) {
    for (const std::size_t pair : met_[disc])
        events_.set(pair, clock_ + time_to_contact(approach(pairs_[pair])));
    events_.set(pairs_.size() + disc, clock_ + time_to_escape(disc));
}

void HardDiscs::list_pairs(double largest) {
    pairs_.clear();
    met_.assign(discs_.size(), {});
    for (HardDisc& d : discs_) {
        d.x = wrapped(d.x, box_.width);
        d.y = wrapped(d.y, box_.height);
    }
    start_ = discs_;
    for (std::size_t i = 0; i < discs_.size(); ++i)
        for (std::size_t j = i + 1; j < discs_.size(); ++j)
            list_images(i, j, (discs_[i].radius + discs_[j].radius) * largest + 2.0 * margin_);
}

void HardDiscs::list_images(std::size_t first, std::size_t second, double reach) {
    const HardDisc& a = discs_[first];
    const HardDisc& b = discs_[second];
    const double nearest_x = shift_to_nearest(b.x - a.x, box_.width);
    const double nearest_y = shift_to_nearest(b.y - a.y, box_.height);
    if (std::abs(b.x + nearest_x - a.x) > reach || std::abs(b.y + nearest_y - a.y) > reach) return;
    for (const double m : {-1.0, 0.0, 1.0}) {
        for (const double n : {-1.0, 0.0, 1.0}) {
            const Pair pair{.first = first,
                            .second = second,
                            .shift_x = nearest_x + m * box_.width,
                            .shift_y = nearest_y + n * box_.height};
            const double x = b.x + pair.shift_x - a.x;
            const double y = b.y + pair.shift_y - a.y;
            if (x * x + y * y > reach * reach) continue;
            met_[first].push_back(pairs_.size());
            met_[second].push_back(pairs_.size());
            pairs_.push_back(pair);
        }
    }
}

}  // namespace crawford
