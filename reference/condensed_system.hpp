/// A linear system whose element interiors are condensed.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <vector>

#include "reference/tensor_space.hpp"

namespace crawford::reference {

/// A linear system over a TensorSpace, assembled element by element. Unknowns inside an element
/// meet no other element: they are eliminated where they stand, and only those on edges enter the
/// sparse solve.
///
/// Unknown = node * components + component, globally and (with local nodes) within an element.
class CondensedSystem {
public:
    CondensedSystem(const TensorSpace& space, int components);

    /// Adds one element's matrix and right side. Each element must be added once.
    void add(int element, const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

    /// Prescribes one unknown on an element edge.
    void hold(int node, int component, double value);

    /// All unknowns, those inside elements too.
    /// \throws std::runtime_error if the matrix is singular.
    Eigen::VectorXd solve() const;

private:
    struct Condensed {
        std::vector<int> edge, inside;  // global unknowns
        Eigen::MatrixXd schur;          // on the edge unknowns
        Eigen::VectorXd right;
        Eigen::MatrixXd response;  // inside = particular - response * edge
        Eigen::VectorXd particular;
    };

    Eigen::VectorXd solve_edges() const;

    const TensorSpace& space_;
    int components_;
    std::vector<int> local_edge_, local_inside_;  // local unknowns
    std::vector<Condensed> parts_;
    std::vector<char> held_;
    Eigen::VectorXd held_value_;
};

}  // namespace crawford::reference
