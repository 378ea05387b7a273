#include "reference/jumping_front.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/require.hpp"

namespace crawford::reference {

JumpingFront::JumpingFront(const JumpingRate& rate)
    : rate_(rate),
      faster_(std::max(rate.strip_rate, rate.outer_rate)),
      slower_(std::min(rate.strip_rate, rate.outer_rate)) {
    require_positive("width", rate.width);
    require_finite("left", rate.left);
    require_finite("right", rate.right);
    require_positive("strip_rate", rate.strip_rate);
    require_positive("outer_rate", rate.outer_rate);
    if (!(strip() > 0.0 && strip() < rate.width))
        throw std::invalid_argument("right must lie above left by less than width");
}

double JumpingFront::slower_width() const {
    return strip_is_faster() ? rate_.width - strip() : strip();
}

double JumpingFront::slower_left() const {
    return strip_is_faster() ? rate_.right : rate_.left;
}

/// Distance from the left end of the slower material [m], in [0, width).
double JumpingFront::place_in_slower(double x) const {
    const double from_left = x - slower_left();
    return from_left - rate_.width * std::floor(from_left / rate_.width);
}

double JumpingFront::rate(double x) const {
    const double place = place_in_slower(x);
    return place > 0.0 && place < slower_width() ? slower_ : faster_;
}

/// r_slow sqrt(1 + p^2) = r_fast: the head wave keeps pace with the faster side.
double JumpingFront::head_slope() const {
    const double ratio = faster_ / slower_;
    return std::sqrt((ratio - 1.0) * (ratio + 1.0));
}

/// Where -r_fast t + p d = -r_slow t, but not beyond the middle of the slower material.
double JumpingFront::head_reach(double t) const {
    require_not_negative("time", t);
    const double middle = 0.5 * slower_width();
    if (faster_ == slower_) return 0.0;
    return std::min((faster_ - slower_) * t / head_slope(), middle);
}

double JumpingFront::height(double x, double t) const {
    const double place = place_in_slower(x);
    const double reach = head_reach(t);
    const double distance = std::min(place, slower_width() - place);
    if (distance <= 0.0) return -faster_ * t;
    return distance <= reach ? head_slope() * distance - faster_ * t : -slower_ * t;
}

double JumpingFront::slope(double x, double t) const {
    const double place = place_in_slower(x);
    const double reach = head_reach(t);
    if (place < reach) return head_slope();
    if (place < slower_width() && slower_width() - place <= reach) return -head_slope();
    return 0.0;
}

double JumpingFront::mean_height(double t) const {
    // Level at the slower rate where no head wave has come, a ramp on either side of that.
    const double reach = head_reach(t);
    const double lag = std::min((faster_ - slower_) * t, head_slope() * reach);
    const double behind = lag * (slower_width() - reach);
    return -faster_ * t + behind / rate_.width;
}

std::vector<double> JumpingFront::kinks(double t) const {
    const double reach = head_reach(t);
    if (reach == 0.0) return {};
    std::vector<double> at{0.0, reach, slower_width() - reach, slower_width()};
    for (double& x : at) {
        const double from_left = x + slower_left() - rate_.left;
        x = rate_.left + std::fmod(from_left, rate_.width);
    }
    std::ranges::sort(at);
    at.erase(std::unique(at.begin(), at.end()), at.end());
    return at;
}

}  // namespace crawford::reference
