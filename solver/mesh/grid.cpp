#include "solver/mesh/grid.hpp"

#include <algorithm>
#include <cmath>

namespace crawford {

Grid::Grid(const Domain& domain, double interface)
    : sides_(domain.half ? Sides::mirror : Sides::periodic),
      cell_columns_(domain.half ? domain.nx / 2 : domain.nx),
      rows_(domain.ny),
      mean_dx_(domain.width / domain.nx),
      width_(mean_dx_ * cell_columns_),
      columns_(columns_of(domain, interface)),
      depth_(domain.depth) {
    for (int i = 0; i < cell_columns_; ++i)
        dx_.push_back(domain.clustering_x == 0.0
                          ? mean_dx_
                          : columns_.x[size_t(i) + 1] - columns_.x[size_t(i)]);
    for (int j = 0; j <= rows_; ++j) {
        // Paper eq. 32 with z = etahat/Ly: eta = Ly z (2 - z^2)^-c.
        const double z = double(j) / rows_ - 1.0;
        const double stretch = std::pow(2.0 - z * z, -domain.clustering);
        const double derivative = stretch * (1.0 + 2.0 * domain.clustering * z * z / (2.0 - z * z));
        eta_.push_back(depth_ * z * stretch);
        metric_.push_back(depth_ * derivative / rows_);
    }
}

NodeColumn Grid::node_column(int i) const {
    const int period = sides_ == Sides::periodic ? cell_columns_ : 2 * cell_columns_;
    const int within = ((i % period) + period) % period;
    if (within < node_columns()) return {within, false};
    return {period - within, true};
}

double mean_height(const Grid& grid, const SurfaceField& surface) {
    double area = 0.0;
    for (int i = 0; i < grid.cell_columns(); ++i)
        area += 0.5 * grid.dx(i) * (surface[size_t(i)] + surface[size_t(grid.right_node(i))]);
    return area / grid.width();
}

double largest_slope(const Grid& grid, const SurfaceField& surface) {
    double largest = 0.0;
    for (int i = 0; i < grid.cell_columns(); ++i)
        largest = std::max(largest, std::abs(grid.slope(surface, i)));
    return largest;
}

double narrowest_column(const Grid& grid) {
    double least = grid.dx(0);
    for (int i = 1; i < grid.cell_columns(); ++i) least = std::min(least, grid.dx(i));
    return least;
}

double lowest_row(const Grid& grid) {
    double least = grid.height(0);
    for (int j = 1; j < grid.rows(); ++j) least = std::min(least, grid.height(j));
    return least;
}

}  // namespace crawford
