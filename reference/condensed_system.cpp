#include "reference/condensed_system.hpp"

#include <stdexcept>

namespace crawford::reference {

CondensedSystem::CondensedSystem(const TensorSpace& space, int components)
    : space_(space),
      components_(components),
      held_(static_cast<std::size_t>(space.nodes() * components), 0),
      held_value_(Eigen::VectorXd::Zero(space.nodes() * components)) {
    const int degree = space.basis().degree();
    for (int j = 0; j <= degree; ++j) {
        for (int i = 0; i <= degree; ++i) {
            const bool edge = i == 0 || j == 0 || i == degree || j == degree;
            for (int c = 0; c < components; ++c) {
                (edge ? local_edge_ : local_inside_)
                    .push_back((j * (degree + 1) + i) * components + c);
            }
        }
    }
}

void CondensedSystem::add(int element, const Eigen::MatrixXd& matrix,
                          const Eigen::VectorXd& right) {
    const auto nodes = space_.element(element).nodes;
    const auto global = [&](int local) {
        return nodes[static_cast<std::size_t>(local / components_)] * components_ +
               local % components_;
    };
    Condensed part;
    for (const int local : local_edge_) part.edge.push_back(global(local));
    for (const int local : local_inside_) part.inside.push_back(global(local));

    const Eigen::PartialPivLU<Eigen::MatrixXd> inside(matrix(local_inside_, local_inside_));
    part.response = inside.solve(matrix(local_inside_, local_edge_));
    part.particular = inside.solve(right(local_inside_));
    part.schur =
        matrix(local_edge_, local_edge_) - matrix(local_edge_, local_inside_) * part.response;
    part.right = right(local_edge_) - matrix(local_edge_, local_inside_) * part.particular;
    parts_.push_back(std::move(part));
}

void CondensedSystem::hold(int node, int component, double value) {
    const int unknown = node * components_ + component;
    held_[static_cast<std::size_t>(unknown)] = 1;
    held_value_[unknown] = value;
}

/// Global vector with the edge unknowns solved, the inside ones still zero.
Eigen::VectorXd CondensedSystem::solve_edges() const {
    constexpr int unnumbered = -1;
    std::vector<int> number(held_.size(), unnumbered);
    std::vector<int> unknowns;
    for (const Condensed& part : parts_) {
        for (const int unknown : part.edge) {
            const auto u = static_cast<std::size_t>(unknown);
            if (held_[u] || number[u] != unnumbered) continue;
            number[u] = static_cast<int>(unknowns.size());
            unknowns.push_back(unknown);
        }
    }
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns.size()));
    for (const Condensed& part : parts_) {
        const Eigen::VectorXd load = part.right - part.schur * held_value_(part.edge);
        for (std::size_t a = 0; a < part.edge.size(); ++a) {
            const int row = number[static_cast<std::size_t>(part.edge[a])];
            if (row == unnumbered) continue;
            right[row] += load[static_cast<Eigen::Index>(a)];
            for (std::size_t b = 0; b < part.edge.size(); ++b) {
                const int column = number[static_cast<std::size_t>(part.edge[b])];
                if (column == unnumbered) continue;
                entries.emplace_back(
                    row, column,
                    part.schur(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)));
            }
        }
    }
    Eigen::SparseMatrix<double> matrix(right.size(), right.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(matrix);
    if (factor.info() != Eigen::Success) {
        throw std::runtime_error("the finite-element matrix is singular");
    }
    const Eigen::VectorXd solution = factor.solve(right);
    Eigen::VectorXd all = held_value_;
    all(unknowns) = solution;
    return all;
}

Eigen::VectorXd CondensedSystem::solve() const {
    Eigen::VectorXd all = solve_edges();
    for (const Condensed& part : parts_) {
        all(part.inside) = part.particular - part.response * all(part.edge);
    }
    return all;
}

}  // namespace crawford::reference
