/// Every truth by name.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/truth.hpp"
#include "reference/truth_parameters.hpp"

namespace crawford::reference {

/// What a truth is, what it wants to know, and what it tells.
struct TruthEntry {
    std::string name;         ///< "slab", "elastic-laminate", ...
    std::string description;  ///< a sentence or two, with the coordinates that it is told in
    std::string source;       ///< the equations of which paper or book, and how they are solved
    std::vector<Parameter> parameters;
    std::vector<Field> fields;
    std::vector<Eigen::Vector2d> examples;  ///< points [m] inside the domain of the standards
    double example_time = 0.0;              ///< [s]
    std::function<Truth(const Given&)> build;

    /// The truth with these parameters, and the standards of all others.
    /// \throws InputError beginning with the truth's name: for an unknown parameter, one
    /// out of its limits, or several that do not go together.
    /// \throws NumericalFailure where no solution is found: parameters may be within their limits and
    /// still far from anything that burns.
    Truth make(const Parameters& given = {}) const;
};

/// In the order in which they are listed: slab, heat, elasticity, motion, surface, manufactured.
const std::vector<TruthEntry>& truths();

/// \throws InputError where there is none of this name, naming the nearest.
const TruthEntry& find_truth(std::string_view name);

/// \see TruthEntry::make \see find_truth
Truth truth(std::string_view name, const Parameters& given = {});

}  // namespace crawford::reference
