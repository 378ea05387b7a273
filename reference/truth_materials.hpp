/// Materials as parameters: one of Table 1 by name, and any of its properties otherwise.
#pragma once

#include <string>
#include <vector>

#include "reference/material.hpp"
#include "reference/truth_parameters.hpp"

namespace crawford::reference {

/// A text PREFIXmaterial, "AP" or "binder", and a number PREFIXproperty for each of `properties`
/// (names as in Material), which hold those of the material where they are not given.
std::vector<Parameter> material_parameters(const std::string& standard,
                                           const std::vector<std::string>& properties,
                                           const std::string& prefix = "");

/// The material that these parameters give.
Material material_of(const Given& given, const std::string& prefix = "");

/// A property by its name, SI. \throws std::logic_error if there is none of this name.
double property_of(const Material& material, const std::string& name);

std::vector<Parameter> joined(std::vector<Parameter> first, const std::vector<Parameter>& second);

/// What conducts and stores heat; what is elastic; what pyrolyses.
const std::vector<std::string>& thermal_properties();
const std::vector<std::string>& elastic_properties();
const std::vector<std::string>& all_properties();

}  // namespace crawford::reference
