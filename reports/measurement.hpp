#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reports/norm.hpp"

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

/// What one grid of a study has shown: errors against a truth, plain values, samples to compare
/// between grids.
class Measurement {
public:
    /// `h` is the cell size that orders are read against, any unit.
    explicit Measurement(double h) : h_(h) {}

    /// The error of a field in L1, L2, Linf and the paper's norm.
    /// \throws std::invalid_argument \see distance
    Measurement& field(const std::string& quantity, std::span<const double> values,
                       std::span<const double> truth, std::span<const double> weights = {});
    /// An error computed elsewhere; `scale` is the size of the truth (1: the error is relative).
    Measurement& error(const std::string& quantity, Norm norm, double error, double scale = 1.0);
    /// A single number, for bounds and for successive differences.
    Measurement& value(const std::string& quantity, double value);
    /// A single number with a truth: its error is gated with Norm::magnitude.
    Measurement& value(const std::string& quantity, double value, double truth);
    /// Values at common points, for gates on successive differences.
    Measurement& sample(const std::string& quantity, Sample sample);

    double h() const { return h_; }
    const std::map<std::pair<std::string, Norm>, ErrorAndScale>& errors() const { return errors_; }
    const std::map<std::string, double>& values() const { return values_; }
    const std::map<std::string, Sample>& samples() const { return samples_; }
    std::optional<ErrorAndScale> error_of(const std::string& quantity, Norm norm) const;
    std::optional<double> value_of(const std::string& quantity) const;
    /// The sample, or the single value as a sample of one.
    std::optional<Sample> sample_of(const std::string& quantity) const;

private:
    double h_;
    std::map<std::pair<std::string, Norm>, ErrorAndScale> errors_;
    std::map<std::string, double> values_;
    std::map<std::string, Sample> samples_;
};

}  // namespace crawford::reports
