#include "cases/scenes/sandwich_measures.hpp"

#include <algorithm>

namespace crawford {

double largest_outward_displacement(const Snapshot& snapshot) {
    const int top = snapshot.position.rows() - 1;
    double largest = 0.0;
    for (int i = 0; i < snapshot.position.columns(); ++i)
        largest =
            std::max(largest, snapshot.position(i, top).y() - snapshot.reference_map(i, top).y());
    return largest;
}

}  // namespace crawford
