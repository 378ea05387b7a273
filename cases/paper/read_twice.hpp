/// Orders of a sandwich on successive grids, read twice: in the paper's way, which takes the finest
/// grid for the truth (paper eq. 55) and is biased, and from differences between successive grids.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/paper/ledger/evidence.hpp"
#include "cases/registry.hpp"
#include "solver/mesh/lattice.hpp"

namespace crawford {

/// What is compared, and the unit it is shown in.
struct Compared {
    std::string name, unit;
    double scale;   ///< of the unit
    bool at_nodes;  ///< or in cells
};

/// Root mean square distance of two fields of a half sandwich over the whole of it, at the points
/// of the coarser. The finer is interpolated bilinearly: nodes coincide, centres of cells lie amid
/// finer cells. Columns on the axis and on the side stand once in the whole, all others twice.
double distance(const Lattice<double>& coarse, const Lattice<double>& fine, bool at_nodes);

/// What Refinement::report() calls the orders of a quantity.
std::string order_in_papers_way(const std::string& set, const std::string& quantity);
std::string order_from_differences(const std::string& set, const std::string& quantity);

/// A set of grids and what it was burnt with, in words; empty where that is the default.
struct OrderSet {
    std::string name, with;
};

/// The paper's order of some quantities (their mean) beside ours of a set and of another.
reports::LedgerRow judged_order(const ledger::Evidence& evidence, const reports::Claim& claim,
                                const std::vector<std::string>& quantities, const OrderSet& set,
                                const OrderSet& other);

/// The four of plane strain, as claims on the order of stress take their mean.
inline const std::vector<std::string> stress_names = {"sigma_11", "sigma_22", "sigma_33", "tau"};

/// One set of grids, coarsest first.
class Refinement {
public:
    /// All fields of one grid, in the order of `quantities`.
    using Fields = std::vector<Lattice<double>>;

    Refinement(std::vector<Compared> quantities, double width);

    void add_grid(int nx, Fields fields);

    /// Adds to the figure a table `set` (dx, then for each quantity its distance to the finest grid
    /// and to the next finer one) and, for quantity k = 1, 2, ..., the variables papers_<set>_<k>
    /// and unbiased_<set>_<k>; the orders also to the findings, with what the unbiased one would
    /// read as in the paper's way.
    void report(Outcome& outcome, const std::string& set) const;

private:
    double h(size_t grid) const { return width_ / nx_[grid]; }
    double between(size_t quantity, size_t coarse, size_t fine) const;

    std::vector<Compared> quantities_;
    double width_;
    std::vector<int> nx_;
    std::vector<Fields> fields_;
};

}  // namespace crawford
