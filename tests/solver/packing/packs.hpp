/// Packs, fluids of discs and what is counted in them, for several tests.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "solver/packing/hard_discs.hpp"
#include "solver/packing/pack.hpp"
#include "solver/packing/random.hpp"

namespace crawford::testing {

inline constexpr double pi = std::numbers::pi;

/// Equal discs of diameter 2 and mass 1 at size 1, at random points, without momentum.
inline HardDiscs fluid(int count, double fraction, std::uint64_t seed, double aspect = 1.0) {
    const double area = count * pi / fraction;
    const Box box{.width = std::sqrt(area / aspect), .height = std::sqrt(area * aspect)};
    Random random(seed);
    std::vector<HardDisc> discs;
    double u = 0, v = 0;
    for (int i = 0; i < count; ++i) {
        discs.push_back({.x = box.width * random.unit(),
                         .y = box.height * random.unit(),
                         .u = random.unit() - 0.5,
                         .v = random.unit() - 0.5,
                         .radius = 1,
                         .mass = 1});
        u += discs.back().u / count;
        v += discs.back().v / count;
    }
    for (HardDisc& disc : discs) {
        disc.u -= u;
        disc.v -= v;
    }
    return {box, discs, 0.0};
}

/// Grown to `size` while the energy is held, then left alone for a while.
inline HardDiscs at_rest_with_itself(HardDiscs discs, double size) {
    const double count = static_cast<double>(discs.discs().size());
    constexpr double growth = 0.02;
    while (discs.size() < size) {
        discs.set_energy(count);
        discs.advance(growth, std::min(size - discs.size(), 0.02) / growth);
    }
    discs.set_energy(count);
    discs.advance(0.0, 50.0);
    return discs;
}

/// Counts pairs by distance, in units of the diameter.
class PairCounts {
public:
    PairCounts(double width, double largest, std::size_t bins)
        : largest_(largest), width_(width), counts_(bins, 0.0) {}

    /// One snapshot of equal discs in a box.
    void add(const std::vector<std::array<double, 2>>& centres, const Box& box, double diameter) {
        const auto n = static_cast<double>(centres.size());
        for (std::size_t i = 0; i < centres.size(); ++i)
            for (std::size_t j = i + 1; j < centres.size(); ++j) {
                const double x = std::remainder(centres[i][0] - centres[j][0], box.width);
                const double y = std::remainder(centres[i][1] - centres[j][1], box.height);
                const double r = std::hypot(x, y) / diameter;
                if (r < largest_) counts_[bin(r)] += 1.0;
            }
        // expected of points independent of each other, in a ring of unit area
        ideal_ += 0.5 * n * (n - 1) * diameter * diameter / (box.width * box.height);
    }

    std::size_t bin(double r) const {
        return r < 1.0 ? 0 : 1 + static_cast<std::size_t>((r - 1.0) / width_);
    }
    /// g of the ring from 1 + (bin - 1) width to 1 + bin width.
    double g(std::size_t bin) const {
        const double inner = 1.0 + width_ * static_cast<double>(bin - 1);
        return counts_[bin] / (ideal_ * pi * width_ * (2 * inner + width_));
    }
    double count(std::size_t bin) const { return counts_[bin]; }

private:
    double largest_, width_;
    std::vector<double> counts_;
    double ideal_ = 0.0;
};

/// The pack of the paper: 21, 11 and 8 discs, 72 % of a box that is 240 um wide.
inline PackRecipe paper_pack() {
    return {.width = 240e-6,
            .discs = {{38.4e-6, 21}, {28.8e-6, 11}, {17.7e-6, 8}},
            .area_fraction = 0.72,
            .smallest_gap = 3e-6,
            .seed = 1};
}

/// A number that any change of any bit changes (FNV-1a).
inline std::uint64_t fingerprint(const Discs& pack) {
    std::uint64_t hash = 14695981039346656037U;
    for (const Disc& disc : pack.discs)
        for (const double value : {disc.x, disc.y})
            hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211U;
    return hash;
}

}  // namespace crawford::testing
