#include "reference/refracted_front.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace crawford::reference {
namespace {

constexpr double left = 0.4, right = 1.0, lean = 0.45, slow = 0.5, fast = 0.9;
const InclinedSlab slab{
    .left = left, .right = right, .lean = lean, .slab_rate = slow, .outer_rate = fast};

/// Arrival times by brute force: faces as rows of points, straight paths within each layer between
/// any two of them, no law of refraction.
class FastestPaths {
public:
    explicit FastestPaths(double deepest) {
        for (int i = 0; i <= samples; ++i) {
            const double y = -deepest * i / samples;
            upper_.push_back({left + lean * y, y, start(left + lean * y, y)});
            lower_.push_back({right + lean * y, y, start(right + lean * y, y)});
        }
        for (int pass = 0; pass < 3; ++pass) {
            relax(upper_, upper_, fast);
            relax(upper_, lower_, slow);
            relax(lower_, lower_, fast);
            relax(lower_, upper_, slow);
        }
    }

    double time(double x, double y) const {
        const bool inside = x >= left + lean * y && x <= right + lean * y;
        double best = start(x, y);
        for (const auto* face : {&upper_, &lower_}) {
            const bool touches = inside || (face == &upper_) == (x < left + lean * y);
            if (!touches) continue;
            for (const Place& from : *face)
                best = std::min(
                    best, from.time + std::hypot(x - from.x, y - from.y) / (inside ? slow : fast));
        }
        return best;
    }

private:
    static constexpr int samples = 700;
    struct Place {
        double x, y, time;
    };
    using Face = std::vector<Place>;

    /// Straight from the nearest point of the start within any layer that holds (x, y).
    static double start(double x, double y) {
        constexpr double slack = 1e-12;
        const double upper = left + lean * y, lower = right + lean * y;
        double best = std::numeric_limits<double>::infinity();
        if (x <= upper + slack)
            best = std::min(best, std::hypot(std::max(x - left, 0.0), y) / fast);
        if (x >= lower - slack)
            best = std::min(best, std::hypot(std::max(right - x, 0.0), y) / fast);
        if (x >= upper - slack && x <= lower + slack)
            best = std::min(best, std::hypot(std::max(left - x, 0.0), y) / slow);
        return best;
    }

    static void relax(const Face& from, Face& to, double rate) {
        for (Place& place : to)
            for (const Place& other : from)
                place.time =
                    std::min(place.time,
                             other.time + std::hypot(place.x - other.x, place.y - other.y) / rate);
    }

    Face upper_, lower_;
};

std::vector<double> places() {
    std::vector<double> x;
    for (int i = 0; i <= 120; ++i) x.push_back(-5.35 + 0.0571 * i);
    return x;
}

bool near(const std::vector<double>& kinks, double x) {
    return std::ranges::any_of(kinks, [&](double kink) { return std::abs(x - kink) < 1e-3; });
}

TEST(RefractedFront, IsWhatTheFastestPathsReach) {
    const RefractedFront front(slab);
    for (const double t : {0.1, 0.5, 1.2, 4.5, 12.0}) {
        const FastestPaths paths(1.05 * fast * t);
        for (const double x : places()) {
            const double time = paths.time(x, front.height(x, t));
            EXPECT_GT(time, t - 1e-12) << x;  // no path is faster
            EXPECT_LT(time, t * (1.0 + 1e-3)) << x << " " << t;
        }
    }
}

TEST(RefractedFront, ObeysItsEquationBetweenKinks) {
    const RefractedFront front(slab);
    constexpr double h = 1e-6;
    for (const double t : {0.3, 1.2, 4.5, 12.0})
        for (const double x : places()) {
            if (near(front.kinks(t), x)) continue;
            const double y = front.height(x, t);
            const double slope = (front.height(x + h, t) - front.height(x - h, t)) / (2.0 * h);
            const double speed = (front.height(x, t + h) - front.height(x, t - h)) / (2.0 * h);
            EXPECT_NEAR(front.slope(x, t), slope, 1e-6) << x << " " << t;
            EXPECT_NEAR(speed, -front.rate(x, y) * std::hypot(1.0, slope), 1e-6) << x << " " << t;
        }
}

TEST(RefractedFront, KnowsTheRateOfEachPlace) {
    InclinedSlab mirrored = slab;
    mirrored.lean = -lean;
    mirrored.width = 2.0;
    for (const double y : {0.0, -0.7, -3.0}) {
        for (const InclinedSlab& one : {slab, mirrored}) {
            const RefractedFront front(one);
            const double face = left + one.lean * y, other = right + one.lean * y;
            EXPECT_EQ(front.rate(face - 1e-9, y), fast);
            EXPECT_EQ(front.rate(face + 1e-9, y), slow);
            EXPECT_EQ(front.rate(other - 1e-9, y), slow);
            EXPECT_EQ(front.rate(other + 1e-9, y), fast);
        }
        EXPECT_EQ(RefractedFront(mirrored).rate(left + 2.1 - lean * y, y), slow);
    }
}

TEST(RefractedFront, KinksAreWhereTheSlopeJumps) {
    const RefractedFront front(slab);
    for (const double t : {0.1, 1.2, 4.5, 12.0})
        for (const double kink : front.kinks(t)) {
            const double jump = front.slope(kink + 1e-9, t) - front.slope(kink - 1e-9, t);
            EXPECT_GT(std::abs(jump), 0.05) << kink << " " << t;
            EXPECT_NEAR(front.height(kink + 1e-9, t), front.height(kink - 1e-9, t), 1e-8);
        }
    EXPECT_EQ(front.kinks(0.1).size(), 4U);
    EXPECT_EQ(front.kinks(1.2).size(), 3U);
    EXPECT_EQ(front.kinks(12.0).size(), 3U);
}

TEST(RefractedFront, CrossesTheFacesOfTheSlab) {
    const RefractedFront front(slab);
    for (const double t : {0.1, 1.2, 4.5, 12.0}) {
        const auto at = front.crossings(t);
        EXPECT_NEAR(at[0], left + lean * front.height(at[0], t), 1e-12);
        EXPECT_NEAR(at[1], right + lean * front.height(at[1], t), 1e-12);
    }
}

TEST(RefractedFront, MirrorsWithItsSlab) {
    InclinedSlab other = slab;
    other.lean = -lean;
    const RefractedFront front(slab), mirrored(other);
    for (const double x : places()) {
        EXPECT_NEAR(front.height(x, 1.2), mirrored.height(left + right - x, 1.2), 1e-14);
        EXPECT_NEAR(front.slope(x, 1.2), -mirrored.slope(left + right - x, 1.2), 1e-14);
    }
}

TEST(RefractedFront, RepeatsInARowUntilSlabsMeet) {
    InclinedSlab row = slab;
    row.width = 2.0;
    const RefractedFront front(row), alone(slab);
    EXPECT_NEAR(front.alone_until(), 1.4 / (lean * fast), 1e-14);
    const double t = 0.9 * front.alone_until();
    for (int k = 0; k < 28; ++k) {
        const double x = right - 1.99 + 0.07 * k;
        EXPECT_DOUBLE_EQ(front.height(x, t), alone.height(x, t));
        EXPECT_NEAR(front.height(x + 4.0, t), front.height(x, t), 1e-13);
    }
    EXPECT_THROW(front.height(0.0, front.alone_until()), std::invalid_argument);
}

TEST(RefractedFront, RefusesWhatIsMissingOrBeyondItsLimits) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const auto with = [&](double InclinedSlab::*member, double value) {
        InclinedSlab changed = slab;
        changed.*member = value;
        return changed;
    };
    EXPECT_THROW(RefractedFront(with(&InclinedSlab::left, nothing)), std::invalid_argument);
    EXPECT_THROW(RefractedFront(with(&InclinedSlab::right, left)), std::invalid_argument);
    EXPECT_THROW(RefractedFront(with(&InclinedSlab::lean, nothing)), std::invalid_argument);
    EXPECT_THROW(RefractedFront(with(&InclinedSlab::slab_rate, 0.0)), std::invalid_argument);
    EXPECT_THROW(RefractedFront(with(&InclinedSlab::slab_rate, 2.0)), std::invalid_argument);
    EXPECT_THROW(RefractedFront(with(&InclinedSlab::width, 0.5)), std::invalid_argument);
    // Down through the slab faster than around; head wave that overhangs.
    EXPECT_THROW(RefractedFront(with(&InclinedSlab::slab_rate, 0.85)), std::invalid_argument);
    EXPECT_THROW(RefractedFront(with(&InclinedSlab::lean, 0.7)), std::invalid_argument);
    EXPECT_THROW(RefractedFront(slab).height(0.0, -1.0), std::invalid_argument);
}

}  // namespace
}  // namespace crawford::reference
