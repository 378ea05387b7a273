#include "solver/packing/apportion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/errors.hpp"

namespace crawford {

namespace {

/// How many discs each share would have if discs came in parts.
std::vector<double> quotas(const std::vector<SizeShare>& shares, int count) {
    std::vector<double> quotas;
    for (const SizeShare& size : shares) quotas.push_back(size.share / (size.radius * size.radius));
    const double sum = std::accumulate(quotas.begin(), quotas.end(), 0.0);
    for (double& quota : quotas) quota *= count / sum;
    return quotas;
}

}  // namespace

std::vector<DiscSize> apportion(const std::vector<SizeShare>& shares, int count) {
    const std::vector<double> wanted = quotas(shares, count);
    std::vector<DiscSize> sizes;
    std::vector<std::size_t> order;
    int left = count;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        sizes.push_back({shares[i].radius, static_cast<int>(wanted[i])});
        order.push_back(i);
        left -= sizes[i].count;
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return wanted[a] - sizes[a].count > wanted[b] - sizes[b].count;
    });
    for (int i = 0; i < left; ++i) ++sizes[order[static_cast<std::size_t>(i)]].count;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (sizes[i].count > 0) continue;
        throw InputError(
            fmt::format("the share of radius {:.6g} um is {:.2g} of {} discs; take more discs, or "
                        "leave that radius out",
                        sizes[i].radius / 1e-6, wanted[i], count));
    }
    return sizes;
}

}  // namespace crawford
