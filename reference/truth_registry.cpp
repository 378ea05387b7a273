#include "reference/truth_registry.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "reference/solved.hpp"
#include "reference/truth_entries.hpp"

namespace crawford::reference {

Truth TruthEntry::make(const Parameters& given) const {
    try {
        return solved([&] { return build(Given(parameters, given)); });
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", name, error.what()));
    }
}

const std::vector<TruthEntry>& truths() {
    static const std::vector<TruthEntry> all{
        slab_entry(),
        slab_shooting_entry(),
        slab_small_strain_entry(),
        adiabatic_column_entry(),
        travelling_layer_entry(),
        thermal_laminate_entry(),
        conducting_inclusion_entry(),
        thermal_sandwich_entry(),
        elastic_laminate_entry(),
        circular_inclusion_entry(),
        faded_inclusion_entry(),
        elastic_sandwich_entry(),
        williams_corner_entry(),
        rigid_rotation_entry(),
        simple_shear_entry(),
        uniaxial_flow_entry(),
        wavy_shear_entry(),
        carried_profile_entry(),
        regressing_wave_entry(),
        regressing_wave_envelope_entry(),
        regressing_zigzag_entry(),
        flux_response_entry(),
        flux_response_shooting_entry(),
        front_ripple_entry(),
        swinging_front_entry(),
        jumping_front_entry(),
        refracted_front_entry(),
        burning_sandwich_front_entry(),
        manufactured_heat_entry(),
        manufactured_elastic_body_entry(),
        manufactured_elastic_strip_entry(),
        manufactured_burning_entry(),
    };
    return all;
}

const TruthEntry& find_truth(std::string_view name) {
    const auto found = std::ranges::find(truths(), name, &TruthEntry::name);
    if (found != truths().end()) return *found;
    std::vector<std::string> names;
    for (const TruthEntry& entry : truths()) names.push_back(entry.name);
    throw InputError(fmt::format("unknown truth {}{}", name, suggestion(name, names)));
}

Truth truth(std::string_view name, const Parameters& given) {
    return find_truth(name).make(given);
}

}  // namespace crawford::reference
