#include "reports/measurement.hpp"

#include <algorithm>
#include <cmath>

namespace crawford::reports {
namespace {

template <typename Map>
std::optional<typename Map::mapped_type> found(const Map& map, const typename Map::key_type& key) {
    const auto at = map.find(key);
    if (at == map.end()) return {};
    return at->second;
}

}  // namespace

Measurement& Measurement::field(const std::string& quantity, std::span<const double> values,
                                std::span<const double> truth, std::span<const double> weights) {
    for (const Norm in : {Norm::L1, Norm::L2, Norm::Linf, Norm::paper})
        error(quantity, in, distance(in, values, truth, weights), norm(in, truth, weights));
    return *this;
}

Measurement& Measurement::error(const std::string& quantity, Norm norm, double error,
                                double scale) {
    errors_[{quantity, norm}] = {error, scale};
    return *this;
}

Measurement& Measurement::value(const std::string& quantity, double value) {
    return this->value(quantity, Amount{value, {}});
}

Measurement& Measurement::value(const std::string& quantity, const Amount& value) {
    const auto at = std::ranges::find(values_, quantity, [](const auto& v) { return v.first; });
    if (at == values_.end())
        values_.emplace_back(quantity, value);
    else
        at->second = value;
    return *this;
}

Measurement& Measurement::value(const std::string& quantity, double value, double truth) {
    this->value(quantity, value);
    return error(quantity, Norm::magnitude, std::abs(value - truth), std::abs(truth));
}

Measurement& Measurement::sample(const std::string& quantity, Sample sample) {
    samples_[quantity] = std::move(sample);
    return *this;
}

std::optional<ErrorAndScale> Measurement::error_of(const std::string& quantity, Norm norm) const {
    return found(errors_, {quantity, norm});
}

std::optional<double> Measurement::value_of(const std::string& quantity) const {
    const auto at = std::ranges::find(values_, quantity, [](const auto& v) { return v.first; });
    if (at == values_.end()) return {};
    return at->second.value;
}

std::optional<Sample> Measurement::sample_of(const std::string& quantity) const {
    if (auto sample = found(samples_, quantity)) return sample;
    if (const auto value = value_of(quantity)) return Sample{{*value}, {}};
    return {};
}

}  // namespace crawford::reports
