/// Names that a user has typed, looked up in the catalogue.
#pragma once

#include <string>
#include <vector>

#include "cases/catalogue/registry.hpp"

namespace crawford {

/// The cases of these names, in the order typed and each once.
/// \throws InputError with the nearest name if one is unknown or cannot be drawn.
std::vector<const Entry*> choose_cases(const std::vector<std::string>& names);

/// The studies of these names, or all if there are none.
/// \throws InputError likewise.
std::vector<const Entry*> choose_studies(const std::vector<std::string>& names);

/// "draft", "paper" or "fine".
/// \throws InputError
Fidelity fidelity_of(const std::string& word);

}  // namespace crawford
