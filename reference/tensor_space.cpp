#include "reference/tensor_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace crawford::reference {
namespace {

void require_ascending(const std::vector<double>& points) {
    const bool falls = std::ranges::adjacent_find(points, std::greater_equal<>()) != points.end();
    if (points.size() < 2 || falls) {
        throw std::invalid_argument("break points must ascend");
    }
}

/// Index of the interval that holds x, the lower one on a shared end.
int interval(const std::vector<double>& points, double x) {
    const auto above = std::lower_bound(points.begin() + 1, points.end() - 1, x);
    return static_cast<int>(above - points.begin()) - 1;
}

}  // namespace

std::vector<double> graded(double from, double to, int layers, double ratio) {
    std::vector<double> points;
    for (int k = 0; k <= layers; ++k) points.push_back(to + (from - to) * std::pow(ratio, k));
    points.front() = from;
    points.push_back(to);
    return points;
}

TensorSpace::TensorSpace(std::vector<double> x, std::vector<double> y, int degree)
    : x_(std::move(x)), y_(std::move(y)), basis_(degree) {
    require_ascending(x_);
    require_ascending(y_);
}

TensorSpace::Element TensorSpace::element(int index) const {
    const int degree = basis_.degree();
    const int ex = index % elements_x();
    const int ey = index / elements_x();
    const auto i = static_cast<std::size_t>(ex);
    const auto j = static_cast<std::size_t>(ey);
    Element element{x_[i], y_[j], x_[i + 1] - x_[i], y_[j + 1] - y_[j], {}};
    for (int row = 0; row <= degree; ++row) {
        for (int column = 0; column <= degree; ++column) {
            element.nodes.push_back(node(ex * degree + column, ey * degree + row));
        }
    }
    return element;
}

TensorSpace::Probe TensorSpace::at(double x, double y) const {
    if (!(x >= x_.front() && x <= x_.back() && y >= y_.front() && y <= y_.back())) {
        throw std::invalid_argument(fmt::format("({}, {}) lies outside the domain", x, y));
    }
    const int index = interval(y_, y) * elements_x() + interval(x_, x);
    const Element where = element(index);
    const double xi = 2.0 * (x - where.left) / where.width - 1.0;
    const double eta = 2.0 * (y - where.bottom) / where.height - 1.0;
    const Eigen::VectorXd along_x = basis_.values(xi);
    const Eigen::VectorXd along_y = basis_.values(eta);
    const Eigen::VectorXd slope_x = basis_.derivatives(xi) * (2.0 / where.width);
    const Eigen::VectorXd slope_y = basis_.derivatives(eta) * (2.0 / where.height);
    // Columns of the outer products run along y, which is the local order of nodes.
    const auto product = [](const Eigen::VectorXd& fx, const Eigen::VectorXd& fy) {
        const Eigen::MatrixXd table = fx * fy.transpose();
        return Eigen::VectorXd(table.reshaped());
    };
    return {index, where.nodes, product(along_x, along_y), product(slope_x, along_y),
            product(along_x, slope_y)};
}

}  // namespace crawford::reference
