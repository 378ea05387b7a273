/// Where the node columns stand: even, or clustered about the interfaces of a sandwich.
#pragma once

#include <vector>

#include "solver/scene/scene.hpp"

namespace crawford {

/// Node columns from left to right, one more than cell columns.
struct Columns {
    std::vector<double> x;       ///< [m]
    std::vector<double> metric;  ///< dx/di at each: the exact slope of x over their count i [m]
};

/// \param interface half the width of what the columns cluster about, the strip |x| <= interface
/// [m], an eighth of the width if it is 0; read only where domain.clustering_x > 0. Then a column
/// stands on each interface, with cells beside it of 2^-clustering_x of the mean width. Between two
/// interfaces, in a part of length L and of m columns, their width changes as
///     dx/di = L/m (1 - (1 - e) cos(2 pi s)),   0 <= s <= 1,
/// which has no kink at the interfaces, where it is e L/m; how many columns each part has makes its
/// widest cell most nearly that of the other.
Columns columns_of(const Domain& domain, double interface);

}  // namespace crawford
