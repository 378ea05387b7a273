#include "reference/truth_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace crawford::reference {

namespace {

struct Property {
    const char* name;
    const char* unit;
    const char* meaning;
    double Material::*member;
    Limits limits;
};

const std::array<Property, 9>& table() {
    static const std::array<Property, 9> all{{
        {"thermal_conductivity", "W/(m K)", "kappa", &Material::thermal_conductivity,
         limits::positive},
        {"specific_heat", "J/(kg K)", "c_p", &Material::specific_heat, limits::positive},
        {"density", "kg/m^3", "rho", &Material::density, limits::positive},
        {"bulk_modulus", "Pa", "K", &Material::bulk_modulus, limits::positive},
        {"shear_modulus", "Pa", "mu", &Material::shear_modulus, limits::positive},
        {"thermal_expansion", "1/K", "alpha, linear", &Material::thermal_expansion,
         limits::not_negative},
        {"pyrolysis_prefactor", "m/s", "A of r_b = A exp(-Ea/(R T_s))",
         &Material::pyrolysis_prefactor, limits::positive},
        {"activation_temperature", "K", "Ea/R", &Material::activation_temperature,
         limits::positive},
        {"heat_of_reaction", "J/kg", "q_s, negative where pyrolysis absorbs heat",
         &Material::heat_of_reaction, limits::finite},
    }};
    return all;
}

const Property& property_named(const std::string& name) {
    const auto found = std::ranges::find(table(), name, &Property::name);
    if (found == table().end()) throw std::logic_error("no property " + name);
    return *found;
}

}  // namespace

double property_of(const Material& material, const std::string& name) {
    return material.*property_named(name).member;
}

std::vector<Parameter> material_parameters(const std::string& standard,
                                           const std::vector<std::string>& properties,
                                           const std::string& prefix) {
    std::vector<Parameter> parameters{
        text(prefix + "material", standard, {"AP", "binder"}, "constituent of Table 1, paper")};
    for (const std::string& name : properties) {
        const Property& property = property_named(name);
        parameters.push_back({.name = prefix + name,
                              .unit = property.unit,
                              .meaning = property.meaning,
                              .standard = {},
                              .otherwise = fmt::format("that of {}material", prefix),
                              .limits = property.limits});
    }
    return parameters;
}

Material material_of(const Given& given, const std::string& prefix) {
    Material material = given.text(prefix + "material") == "AP" ? ap() : binder();
    for (const Property& property : table()) {
        double& value = material.*property.member;
        value = given.number_or(prefix + property.name, value);
    }
    return material;
}

std::vector<Parameter> joined(std::vector<Parameter> first, const std::vector<Parameter>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

const std::vector<std::string>& thermal_properties() {
    static const std::vector<std::string> names{"thermal_conductivity", "specific_heat", "density"};
    return names;
}

const std::vector<std::string>& elastic_properties() {
    static const std::vector<std::string> names{"bulk_modulus", "shear_modulus"};
    return names;
}

const std::vector<std::string>& all_properties() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Property& property : table()) all.emplace_back(property.name);
        return all;
    }();
    return names;
}

}  // namespace crawford::reference
