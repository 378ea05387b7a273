/// Which runs of which studies `crawford verify` is asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "program/choose.hpp"
#include "program/commands.hpp"

namespace crawford {

/// The decimal whole numbers that an option was given: "032" is 32.
/// \throws InputError naming the option and the first word that is none.
std::vector<int> whole_numbers(const std::string& option, const std::vector<std::string>& words);

/// Values that the command line gives for the axis that studies refine.
class ChosenGrids {
public:
    /// \throws InputError if --grids or --axis cannot be read or holds a value below 1, or if
    /// --grids is given for an entry that is named and refines several axes: it does not say which.
    ChosenGrids(const VerifyOptions& options, const std::vector<ChosenStudy>& chosen);

    /// Whether anything was chosen: else every study runs on all its own.
    bool any() const { return !values_.empty(); }

    /// What a study runs on: nothing said, its own. Of a study that is named all values that were
    /// given, of others those of its own that were. None at all if it refines another axis.
    /// \throws InputError if a value is out of reach of a study that is named.
    std::optional<std::vector<int>> of(const reports::Study& study) const;

    /// "--grids = 32,64" or "--axis = rows=32,64", for messages.
    std::string typed() const;

    /// "--grids 32,64" or "--axis rows=32,64", as it would be typed for these values of a study.
    std::string option(const reports::Study& study, const std::vector<int>& values) const;

private:
    void read_axis(const std::string& text);
    void refuse_several_axes(const std::vector<std::string>& names,
                             const std::vector<ChosenStudy>& chosen) const;

    std::string axis_;  ///< empty: whichever a study refines
    std::vector<int> values_;
    bool named_;
};

}  // namespace crawford
