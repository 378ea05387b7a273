#include "cases/paper/ledger/evidence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "cases/paper/ledger/refinements.hpp"

namespace crawford::ledger {

using reports::OtherReading;

namespace {

const reports::Refinement* find(const Evidence& evidence, const std::string& of,
                                const Measure& measure, const std::string& direction) {
    const auto found = std::ranges::find_if(evidence.refinements, [&](const auto& r) {
        return r.of == of && r.quantity == measure.what && r.direction == direction;
    });
    return found == evidence.refinements.end() ? nullptr : &*found;
}

}  // namespace

std::function<double(const std::string& what)> Evidence::findings_of(
    const std::string& entry) const {
    return [this, entry](const std::string& what) { return finding(entry, what); };
}

std::optional<double> index(const Evidence& evidence, const std::string& of, const Measure& measure,
                            const std::string& direction) {
    const auto* found = find(evidence, of, measure, direction);
    if (found == nullptr || found->verdict == diverging) return {};
    return found->index;
}

std::string divergence(const Evidence& evidence, const std::string& of, const Measure& measure,
                       const std::string& direction) {
    const auto* found = find(evidence, of, measure, direction);
    if (found == nullptr || found->verdict != diverging) return {};
    std::vector<std::string> values;
    for (const double value : found->values) values.push_back(fmt::format("{:.4g}", value));
    return fmt::format("No interval from the grid, for it does not converge there: {}.",
                       fmt::join(values, ", "));
}

std::vector<OtherReading> others(const reports::ReadingMatrix& matrix,
                                 const std::string& quantity) {
    const auto column = std::ranges::find(matrix.quantities, quantity, &reports::Quantity::name);
    if (column == matrix.quantities.end())
        throw std::logic_error(fmt::format("{} has no {}", matrix.title, quantity));
    const auto k = size_t(column - matrix.quantities.begin());
    auto runs = matrix.runs;
    std::ranges::stable_sort(runs, {}, [](const auto& run) { return run.set.size(); });
    std::vector<OtherReading> others;
    for (const auto& run : runs)
        if (!run.set.empty() && std::isfinite(run.values[k]))
            others.push_back({run.reading + " (" + matrix.grid + ")", run.values[k]});
    return others;
}

std::vector<OtherReading> before(OtherReading first, std::vector<OtherReading> others) {
    others.insert(others.begin(), std::move(first));
    return others;
}

std::vector<OtherReading> times(std::vector<OtherReading> others, double factor) {
    for (OtherReading& other : others) other.value *= factor;
    return others;
}

std::vector<OtherReading> plus(std::vector<OtherReading> others, double offset) {
    for (OtherReading& other : others) other.value += offset;
    return others;
}

}  // namespace crawford::ledger
