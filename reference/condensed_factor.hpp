/// A factorisation that eliminates the nodes inside elements first.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <vector>

#include "reference/tensor_space.hpp"

namespace crawford::reference {

/// A factored linear system over a TensorSpace, one unknown a node, zero along the bottom, for many
/// right sides. What is inside an element is eliminated where it stands; \see CondensedSystem.
class CondensedFactor {
public:
    /// \param matrices of each element in order, on its nodes
    /// \throws std::runtime_error if the matrix is singular.
    CondensedFactor(const TensorSpace& space, const std::vector<Eigen::MatrixXd>& matrices);

    /// The surface nodes of the solutions, from left to right.
    /// \param forces nodes x right sides
    Eigen::MatrixXd surface(const Eigen::MatrixXd& forces) const;
    /// All nodes of one solution.
    Eigen::VectorXd solve(const Eigen::VectorXd& force) const;

private:
    struct Part {
        std::vector<int> edge, inside;              // nodes
        Eigen::PartialPivLU<Eigen::MatrixXd> core;  // on the inside nodes
        Eigen::MatrixXd response;                   // inside = particular - response * edge
        Eigen::MatrixXd pull;                       // of the inside nodes on the edge ones
        Eigen::MatrixXd schur;                      // on the edge nodes
    };

    void number_edges();
    void factor_edges();
    Eigen::MatrixXd solve_edges(const Eigen::MatrixXd& forces) const;

    const TensorSpace& space_;
    std::vector<Part> parts_;
    std::vector<int> number_;  // of each node in the sparse system, or `held`
    std::vector<int> nodes_;   // of the sparse system
    Eigen::SparseLU<Eigen::SparseMatrix<double>> factor_;
};

}  // namespace crawford::reference
