#include <cmath>
#include <numbers>

#include "reference/front_ripple.hpp"
#include "reference/onset.hpp"
#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"
#include "reference/truth_materials.hpp"

namespace crawford::reference {

namespace {

std::vector<Parameter> front_parameters(const std::vector<std::string>& more_properties,
                                        const std::vector<Parameter>& others) {
    auto properties = thermal_properties();
    properties.insert(properties.end(), {"pyrolysis_prefactor", "activation_temperature"});
    properties.insert(properties.end(), more_properties.begin(), more_properties.end());
    return joined(
        joined(material_parameters("AP", properties),
               {number("heat_flux", "W/m^2", 200.0 * calorie_per_second_per_cm2, limits::positive,
                       "Q, from the flame"),
                number("cold_temperature", "K", 300.0, limits::positive, "T0, far below")}),
        others);
}

SlabConditions half_space(const Given& given) {
    return {.material = material_of(given),
            .model = SlabModel::thermal,
            .regression = Regression::pyrolysis,
            .heat_flux = given.number("heat_flux"),
            .pressure = 0.0,
            .cold_temperature = given.number("cold_temperature")};
}

Fields ripple_fields() {
    return joined(
        {surface_field(), temperature_field(),
         scalar_field("growth_rate", "1/s", "sigma, the same at every point"),
         scalar_field("burn_rate", "m/s", "r of the flat front, the same at every point")});
}

/// Where a front is at (x, t), and all below it; a micrometre more, for a surface found by somebody
/// else.
Domain below(const std::function<double(double x, double t)>& surface) {
    return {.y = {.to = 1e-6}, .surface = surface};
}

Truth ripple_truth(const Given& given) {
    const double wave_number =
        2.0 * std::numbers::pi * given.number("waves") / given.number("width");
    const FrontRipple ripple(half_space(given), wave_number);
    const auto height = [ripple, wave_number, a = given.number("amplitude")](double x, double t) {
        return a * std::cos(wave_number * x) * std::exp(ripple.growth_rate() * t);
    };
    const auto surface = [ripple, height](double x, double t) {
        return height(x, t) - ripple.front().burn_rate * t;
    };
    return pointwise(ripple_fields(), below(surface), [=](const Eigen::Vector2d& at, double t) {
        const double phi = surface(at.x(), t);
        const double eta = at.y() - phi;
        return Row()
            .add(phi)
            .add(ripple.front().temperature(eta) + height(at.x(), t) * ripple.temperature(eta))
            .add(ripple.growth_rate())
            .add(ripple.front().burn_rate);
    });
}

Fields swinging_fields() {
    return joined(
        {ripple_fields(),
         scalar_field("angular_frequency", "1/s", "of the swing, the same at every point"),
         scalar_field("heat_of_reaction_at_onset", "J/kg",
                      "q_s from which on such a front swings ever more")});
}

Truth swinging_truth(const Given& given) {
    const SlabConditions conditions = half_space(given);
    const SwingingFront front(conditions);
    const double onset = heat_of_reaction_at_onset(conditions);
    const auto swing = [front, a = given.number("amplitude")](double t) {
        return a * std::exp(front.growth_rate() * t);
    };
    const auto surface = [front, swing](double, double t) {
        return swing(t).real() - front.front().burn_rate * t;
    };
    return pointwise(swinging_fields(), below(surface), [=](const Eigen::Vector2d& at, double t) {
        const double phi = surface(at.x(), t);
        const double eta = at.y() - phi;
        return Row()
            .add(phi)
            .add(front.front().temperature(eta) + (swing(t) * front.temperature(eta)).real())
            .add(front.growth_rate().real())
            .add(front.front().burn_rate)
            .add(front.growth_rate().imag())
            .add(onset);
    });
}

}  // namespace

TruthEntry front_ripple_entry() {
    return {.name = "front-ripple",
            .description =
                "A ripple of the flat front of a burning, rigid half space as it dies, with the "
                "temperature below it; exact to second order in the amplitude. y in the "
                "laboratory.",
            .source =
                "paper eq. 7, 9 and 11 without mechanics, linearised about the steady front; "
                "reference/front_ripple.hpp",
            .parameters = front_parameters(
                {"heat_of_reaction"},
                {number("width", "m", 240e-6, limits::positive, "period in x"),
                 number("waves", "1", 1.0, {.from = 1.0, .whole = true}, "over the width"),
                 number("amplitude", "m", 0.1e-6, limits::finite, "of the surface at t = 0")}),
            .fields = ripple_fields(),
            .examples = lattice({0.0, 120e-6}, {-200e-6, -10e-6}),
            .example_time = 1e-3,
            .build = ripple_truth};
}

TruthEntry swinging_front_entry() {
    return {.name = "swinging-front",
            .description =
                "The flat front of a burning, rigid half space whose pyrolysis frees heat, as it "
                "swings, ever less or ever more; exact to second order in the amplitude. y in the "
                "laboratory.",
            .source =
                "paper eq. 7, 9 and 11 without mechanics, linearised about the steady front; "
                "reference/onset.hpp",
            .parameters = front_parameters(
                {}, {number("heat_of_reaction", "J/kg", 0.45e6, limits::positive,
                            "q_s, which pyrolysis frees"),
                     number("amplitude", "m", 1e-8, limits::finite, "of the front at t = 0")}),
            .fields = swinging_fields(),
            .examples = lattice({0.0, 120e-6}, {-200e-6, -20e-6}),
            .example_time = 1e-3,
            .build = swinging_truth};
}

}  // namespace crawford::reference
