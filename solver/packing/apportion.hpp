/// Whole discs from a distribution of sizes.
#pragma once

#include <vector>

#include "solver/packing/pack.hpp"

namespace crawford {

/// What a sieve says: this part of the particles' area is discs of this radius.
struct SizeShare {
    double radius;  ///< [m]
    double share;   ///< of the area, relative to the sum of all shares
};

/// `count` discs whose areas come nearest to the shares: discs are as many as share over area, in
/// proportion; whole parts first, then those with the largest remainders, the earlier of equals.
/// \throws InputError if a share is left without a disc
std::vector<DiscSize> apportion(const std::vector<SizeShare>& shares, int count);

}  // namespace crawford
