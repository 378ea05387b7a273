#include "solver/mesh/columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace crawford {

namespace {

/// A part between two interfaces, of length L in m cells, as wide at its ends as it is told.
class Part {
public:
    Part(double length, int cells, double end_width)
        : length_(length), cells_(cells), end_(end_width * cells / length) {}

    double place(double s) const {  ///< from the left end [m]
        const double turn = 2.0 * std::numbers::pi * s;
        return length_ * (s - (1.0 - end_) * std::sin(turn) / (2.0 * std::numbers::pi));
    }
    double metric(double s) const {  ///< dx/d(cells) [m]
        const double turn = 2.0 * std::numbers::pi * s;
        return length_ / cells_ * (1.0 - (1.0 - end_) * std::cos(turn));
    }

private:
    double length_;
    int cells_;
    double end_;  // width of a cell at the ends, in means of the part
};

/// From the middle of the strip, x = 0, to the middle of what surrounds it.
Columns clustered_half(const Domain& d, double interface) {
    const int cells = d.nx / 2;
    const double narrowest = d.width / d.nx * std::exp2(-d.clustering_x);
    const auto strip = [&](int n) { return Part(2.0 * interface, 2 * n, narrowest); };
    const auto outer = [&](int n) {
        return Part(d.width - 2.0 * interface, 2 * (cells - n), narrowest);
    };
    int best = 1;
    double least = std::numeric_limits<double>::infinity();
    for (int n = 1; n < cells; ++n) {
        const double unlike = std::abs(std::log(strip(n).metric(0.5) / outer(n).metric(0.5)));
        if (unlike < least) {
            least = unlike;
            best = n;
        }
    }
    Columns half;
    const auto add = [&](double x, double metric) {
        half.x.push_back(x);
        half.metric.push_back(metric);
    };
    const Part inner = strip(best), around = outer(best);
    for (int k = 0; k < best; ++k) {
        const double s = 0.5 + 0.5 * k / best;
        add(inner.place(s) - interface, inner.metric(s));
    }
    for (int k = 0; k <= cells - best; ++k) {
        const double s = 0.5 * k / (cells - best);
        add(interface + around.place(s), around.metric(s));
    }
    half.x.front() = 0.0;
    half.x[size_t(best)] = interface;
    return half;
}

Columns mirrored(const Columns& half) {
    Columns whole;
    for (size_t k = half.x.size() - 1; k > 0; --k) {
        whole.x.push_back(-half.x[k]);
        whole.metric.push_back(half.metric[k]);
    }
    whole.x.insert(whole.x.end(), half.x.begin(), half.x.end());
    whole.metric.insert(whole.metric.end(), half.metric.begin(), half.metric.end());
    return whole;
}

Columns even(const Domain& d) {
    const double dx = d.width / d.nx;
    const double left = d.half ? 0.0 : -0.5 * d.width;
    const int cells = d.half ? d.nx / 2 : d.nx;
    Columns columns;
    for (int i = 0; i <= cells; ++i) {
        columns.x.push_back(left + dx * i);
        columns.metric.push_back(dx);
    }
    return columns;
}

}  // namespace

Columns columns_of(const Domain& domain, double interface) {
    if (domain.clustering_x == 0.0) return even(domain);
    const Columns half = clustered_half(domain, interface > 0.0 ? interface : domain.width / 8.0);
    return domain.half ? half : mirrored(half);
}

}  // namespace crawford
