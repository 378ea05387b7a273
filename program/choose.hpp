/// Names that a user has typed, looked up in the catalogue.
#pragma once

#include <string>
#include <vector>

#include "cases/registry.hpp"

namespace crawford {

/// The cases of these names, in the order typed and each once.
/// \throws InputError with the nearest name if one is unknown or cannot be drawn.
std::vector<const Entry*> choose_cases(const std::vector<std::string>& names);

/// Every case that can be drawn.
std::vector<const Entry*> all_cases();

/// A study and the entry of the catalogue that it belongs to.
struct ChosenStudy {
    const Entry* entry;
    reports::Study study;
    std::string name;  ///< by which this study and no other is chosen
    double seconds;    ///< that it is expected to take: the entry's cost, shared out
};

/// The studies of these names in the catalogue's order, or all if there are none. A name is that of
/// an entry, which means all its studies, or that of one study.
/// \throws InputError likewise.
std::vector<ChosenStudy> choose_studies(const std::vector<std::string>& names);

/// "draft", "paper" or "fine".
/// \throws InputError
Fidelity fidelity_of(const std::string& word);

}  // namespace crawford
