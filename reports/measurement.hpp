/// What a run has found: errors, samples and numbers, by name.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reports/norm.hpp"
#include "reports/setting.hpp"

namespace crawford::reports {

/// An error and the size of the truth in the same norm and unit.
struct ErrorAndScale {
    double error;
    double scale;
};

/// Values at points that every grid of a study shares (nodes of the coarsest, say), with the size
/// each stands for.
struct Sample {
    std::vector<double> values;
    std::vector<double> weights;  ///< Empty: all alike
};

/// What one run has found: errors against a truth, plain values, samples to compare
/// between grids.
class Measurement {
public:
    /// `h` is the cell size that orders are read against, any unit.
    explicit Measurement(double h) : h_(h) {}
    /// Of a run that no order is read from: its h is NaN.
    Measurement() : h_(std::numeric_limits<double>::quiet_NaN()) {}

    /// The error of a field in L1, L2, Linf and the paper's norm.
    /// \throws std::invalid_argument \see distance
    Measurement& field(const std::string& quantity, std::span<const double> values,
                       std::span<const double> truth, std::span<const double> weights = {});
    /// An error computed elsewhere; `scale` is the size of the truth (1: the error is relative).
    Measurement& error(const std::string& quantity, Norm norm, double error, double scale = 1.0);
    /// A single number, for bounds and for successive differences.
    Measurement& value(const std::string& quantity, double value);
    /// The same with its unit.
    Measurement& value(const std::string& quantity, const Amount& value);
    /// A single number with a truth: its error is gated with Norm::magnitude.
    Measurement& value(const std::string& quantity, double value, double truth);
    /// Values at common points, for gates on successive differences.
    Measurement& sample(const std::string& quantity, Sample sample);

    double h() const { return h_; }
    const std::map<std::pair<std::string, Norm>, ErrorAndScale>& errors() const { return errors_; }
    /// Plain values in the order in which they were given; without a unit it is empty.
    const std::vector<std::pair<std::string, Amount>>& values() const { return values_; }
    const std::map<std::string, Sample>& samples() const { return samples_; }
    std::optional<ErrorAndScale> error_of(const std::string& quantity, Norm norm) const;
    std::optional<double> value_of(const std::string& quantity) const;
    /// The sample, or the single value as a sample of one.
    std::optional<Sample> sample_of(const std::string& quantity) const;

private:
    double h_;
    std::map<std::pair<std::string, Norm>, ErrorAndScale> errors_;
    std::vector<std::pair<std::string, Amount>> values_;
    std::map<std::string, Sample> samples_;
};

}  // namespace crawford::reports
