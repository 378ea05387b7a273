#include "reference/condensed_factor.hpp"

#include <stdexcept>

namespace crawford::reference {
namespace {

constexpr int held = -1;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

}  // namespace

CondensedFactor::CondensedFactor(const TensorSpace& space,
                                 const std::vector<Eigen::MatrixXd>& matrices)
    : space_(space), number_(at(space.nodes()), held) {
    const int degree = space.basis().degree();
    std::vector<int> edge, inside;
    for (int j = 0; j <= degree; ++j) {
        for (int i = 0; i <= degree; ++i) {
            const bool on_edge = i == 0 || j == 0 || i == degree || j == degree;
            (on_edge ? edge : inside).push_back(j * (degree + 1) + i);
        }
    }
    for (int e = 0; e < space.elements(); ++e) {
        const auto nodes = space.element(e).nodes;
        const Eigen::MatrixXd& matrix = matrices[at(e)];
        Part part;
        for (const int local : edge) part.edge.push_back(nodes[at(local)]);
        for (const int local : inside) part.inside.push_back(nodes[at(local)]);
        part.core.compute(matrix(inside, inside));
        part.response = part.core.solve(matrix(inside, edge));
        part.pull = matrix(edge, inside);
        part.schur = matrix(edge, edge) - part.pull * part.response;
        parts_.push_back(std::move(part));
    }
    number_edges();
    factor_edges();
}

void CondensedFactor::number_edges() {
    for (const Part& part : parts_) {
        for (const int node : part.edge) {
            const bool on_bottom = node < space_.columns();
            if (on_bottom || number_[at(node)] != held) continue;
            number_[at(node)] = static_cast<int>(nodes_.size());
            nodes_.push_back(node);
        }
    }
}

void CondensedFactor::factor_edges() {
    std::vector<Eigen::Triplet<double>> entries;
    for (const Part& part : parts_) {
        for (std::size_t a = 0; a < part.edge.size(); ++a) {
            for (std::size_t b = 0; b < part.edge.size(); ++b) {
                const int row = number_[at(part.edge[a])], column = number_[at(part.edge[b])];
                if (row == held || column == held) continue;
                entries.emplace_back(
                    row, column,
                    part.schur(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)));
            }
        }
    }
    const auto size = static_cast<Eigen::Index>(nodes_.size());
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    factor_.compute(matrix);
    if (factor_.info() != Eigen::Success) {
        throw std::runtime_error("the finite-element matrix is singular");
    }
}

/// All nodes x right sides, those inside elements still zero.
Eigen::MatrixXd CondensedFactor::solve_edges(const Eigen::MatrixXd& forces) const {
    Eigen::MatrixXd right = forces;
    for (const Part& part : parts_) {
        right(part.edge, Eigen::all) -=
            part.pull * part.core.solve(forces(part.inside, Eigen::all));
    }
    const Eigen::MatrixXd on_edges = right(nodes_, Eigen::all);
    const Eigen::MatrixXd solved = factor_.solve(on_edges);
    Eigen::MatrixXd solution = Eigen::MatrixXd::Zero(forces.rows(), forces.cols());
    solution(nodes_, Eigen::all) = solved;
    return solution;
}

Eigen::MatrixXd CondensedFactor::surface(const Eigen::MatrixXd& forces) const {
    return solve_edges(forces).bottomRows(space_.columns());
}

Eigen::VectorXd CondensedFactor::solve(const Eigen::VectorXd& force) const {
    Eigen::VectorXd all = solve_edges(force);
    for (const Part& part : parts_) {
        all(part.inside) =
            part.core.solve(Eigen::VectorXd(force(part.inside))) - part.response * all(part.edge);
    }
    return all;
}

}  // namespace crawford::reference
