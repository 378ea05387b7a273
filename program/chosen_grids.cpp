#include "program/chosen_grids.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <numeric>
#include <sstream>

#include "base/errors.hpp"

namespace crawford {

namespace {

std::vector<std::string> words_in(const std::string& text) {
    std::vector<std::string> found;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) found.push_back(word);
    return found;
}

/// How far from its own grids a study is run: coarser than a quarter of its coarsest, its pieces
/// (patches, layers, samples) have no cells of their own; finer than eight times its finest, a run
/// takes days and all the memory. Steps, layers and samples of a grid divide the study's own grids and
/// half of them, and would be cut to whole numbers between, unless it says that it has none.
void refuse_out_of_reach(const reports::Study& study, const std::vector<int>& values,
                         const std::string& typed) {
    if (study.is_a_list()) {
        const auto last = int(study.grids().size());
        if (std::ranges::any_of(values, [&](int value) { return value > last; }))
            throw InputError(
                fmt::format("{}: {} has a {} 1 to {}", typed, study.name(), study.axis(), last));
        return;
    }
    constexpr int coarser = 4;
    constexpr int finer = 8;
    const auto [least, most] = std::ranges::minmax(study.grids());
    int divisor = 0;
    for (const int grid : study.grids()) divisor = std::gcd(divisor, grid);
    divisor = study.takes_any_value() ? 1 : std::max(1, divisor / 2);
    const int smallest = std::max(divisor, least / coarser);
    const long largest = long(most) * finer;
    for (const int value : values)
        if (value < smallest || value > largest || value % divisor != 0)
            throw InputError(fmt::format(
                "{}: {} takes {} from {} to {}{}", typed, study.name(), study.axis(), smallest,
                largest, divisor > 1 ? fmt::format(" in multiples of {}", divisor) : ""));
}

/// Axes that the studies refine, each once.
std::vector<std::string> axes_of(const std::vector<ChosenStudy>& chosen) {
    std::vector<std::string> axes;
    for (const ChosenStudy& one : chosen)
        if (std::ranges::find(axes, one.study.axis()) == axes.end())
            axes.push_back(one.study.axis());
    return axes;
}

}  // namespace

std::vector<int> whole_numbers(const std::string& option, const std::vector<std::string>& words) {
    std::vector<int> values;
    for (const std::string& word : words) {
        int value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (word.empty() || error != std::errc() || end != word.data() + word.size())
            throw InputError(fmt::format("{} = {}: \"{}\" is no whole number", option,
                                         fmt::join(words, ","), word));
        values.push_back(value);
    }
    return values;
}

ChosenGrids::ChosenGrids(const VerifyOptions& options, const std::vector<ChosenStudy>& chosen)
    : values_(options.grids), named_(!options.studies.empty()) {
    if (!options.axis.empty()) read_axis(options.axis);
    for (const int value : values_)
        if (value < 1)
            throw InputError(fmt::format("{} holds {}; a grid is 1 or more",
                                         axis_.empty() ? "--grids" : "--axis", value));
    const auto axes = axes_of(chosen);
    if (!axis_.empty() && std::ranges::find(axes, axis_) == axes.end())
        throw InputError(fmt::format("--axis: no study here refines \"{}\"; choose one of {}",
                                     axis_, fmt::join(axes, ", ")));
    if (!options.grids.empty()) refuse_several_axes(options.studies, chosen);
}

void ChosenGrids::read_axis(const std::string& text) {
    const size_t equals = text.find('=');
    axis_ = text.substr(0, equals);
    if (equals == std::string::npos || axis_.empty())
        throw InputError(fmt::format("--axis = {}; give NAME=N,N,...", text));
    values_ = whole_numbers("--axis " + axis_, words_in(text.substr(equals + 1)));
    if (values_.empty()) throw InputError(fmt::format("--axis = {}: no value is given", text));
}

void ChosenGrids::refuse_several_axes(const std::vector<std::string>& names,
                                      const std::vector<ChosenStudy>& chosen) const {
    for (const std::string& name : names) {
        std::vector<ChosenStudy> own;
        std::ranges::copy_if(chosen, std::back_inserter(own), [&](const ChosenStudy& one) {
            return one.entry->name == name && one.study.name() != name;
        });
        const auto axes = axes_of(own);
        if (axes.size() > 1)
            throw InputError(
                fmt::format("--grids: {0} refines {1}; say which, as in --axis "
                            "{2}={3}",
                            name, fmt::join(axes, ", "), axes.front(), fmt::join(values_, ",")));
    }
}

std::optional<std::vector<int>> ChosenGrids::of(const reports::Study& study) const {
    if (!any()) return {};
    if (!axis_.empty() && study.axis() != axis_) return std::vector<int>{};
    if (named_) {
        refuse_out_of_reach(study, values_, typed());
        return values_;
    }
    if (axis_.empty() && study.is_a_list()) return std::vector<int>{};  // no grids
    auto values = study.grids();
    std::erase_if(values,
                  [&](int value) { return std::ranges::find(values_, value) == values_.end(); });
    return values;
}

std::string ChosenGrids::typed() const {
    if (axis_.empty()) return fmt::format("--grids = {}", fmt::join(values_, ","));
    return fmt::format("--axis = {}={}", axis_, fmt::join(values_, ","));
}

std::string ChosenGrids::option(const reports::Study& study, const std::vector<int>& values) const {
    if (axis_.empty()) return fmt::format("--grids {}", fmt::join(values, ","));
    return fmt::format("--axis {}={}", study.axis(), fmt::join(values, ","));
}

}  // namespace crawford
