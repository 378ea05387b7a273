/// What a study found beside what is true, entry by entry, until it is reported as one error.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "reports/measurement.hpp"
#include "solver/element/stress_field.hpp"

namespace crawford {

struct Comparison {
    std::vector<double> found, exact, weight;

    void add(double f, double e, double w = 1.0) {
        found.push_back(f);
        exact.push_back(e);
        weight.push_back(w);
    }
    void add(const Deviator& f, const Deviator& e, double w = 1.0) {
        add(f.s11, e.s11, w);
        add(f.s22, e.s22, w);
        add(f.s12, e.s12, w);
    }
    void add(const Vector& f, const Vector& e, double w = 1.0) {
        for (int k = 0; k < 2; ++k) add(f[k], e[k], w);
    }
    void add(const Eigen::Matrix2d& f, const Eigen::Matrix2d& e, double w = 1.0) {
        for (int k = 0; k < 4; ++k) add(f(k / 2, k % 2), e(k / 2, k % 2), w);
    }

    void report(const std::string& quantity, reports::Measurement& to) const {
        to.field(quantity, found, exact, weight);
    }
};

}  // namespace crawford
