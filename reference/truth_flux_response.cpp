#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "reference/flux_response.hpp"
#include "reference/flux_response_shooting.hpp"
#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"
#include "reference/truth_materials.hpp"

namespace crawford::reference {

namespace {

using Complex = std::complex<double>;

std::vector<Parameter> swing_parameters() {
    return {
        number("heat_flux", "W/m^2", 200.0 * calorie_per_second_per_cm2, limits::positive,
               "Q, the mean, from the flame"),
        number("frequency", "Hz", 200.0, limits::positive, "f"),
        number("amplitude", "1", 0.01, {.from = 0.0, .to = 1.0}, "a of 1 + a cos(2 pi f t)"),
        number("cold_temperature", "K", 300.0, limits::positive, "T0, far below or at the bottom"),
        number("depth", "m", limits::infinity, limits::positive_or_infinite,
               "of the layer; infinity for a half space")};
}

std::vector<Parameter> rigid_parameters() {
    auto properties = thermal_properties();
    properties.insert(properties.end(),
                      {"pyrolysis_prefactor", "activation_temperature", "heat_of_reaction"});
    return joined(material_parameters("AP", properties), swing_parameters());
}

std::vector<Parameter> expanding_parameters() {
    return joined(joined(material_parameters("AP", all_properties()),
                         {text("thermal_stress", "3 alpha K", {"3 alpha K", "alpha K"}, "beta"),
                          text("heat_capacity", "c_p", {"c_p", "c_v"},
                               "which specific heat stands before DT/Dt")}),
                  swing_parameters());
}

SlabConditions conditions_of(const Given& given) {
    return {.material = material_of(given),
            .model = SlabModel::thermal,
            .regression = Regression::pyrolysis,
            .heat_flux = given.number("heat_flux"),
            .pressure = 0.0,
            .cold_temperature = given.number("cold_temperature"),
            .depth = given.number("depth")};
}

Fields rigid_fields() {
    return joined({temperature_field(),
                   scalar_field("surface_temperature", "K", "T_s, the same at every point"),
                   scalar_field("burn_rate", "m/s", "r_b, the same at every point"),
                   scalar_field("burn_rate_response", "1",
                                "|r'/r|/a: by how much more the rate swings than the flux"),
                   scalar_field("burn_rate_lead", "1", "how much earlier, an angle in radians")});
}

Fields expanding_fields() {
    return joined(
        {rigid_fields(), vector_fields("velocity", "m/s", "of the solid above its cold speed")});
}

/// The swing at a time.
struct Moment {
    explicit Moment(const Given& given)
        : amplitude(given.number("amplitude")),
          angular_frequency(2.0 * std::numbers::pi * given.number("frequency")) {}
    double of(Complex swing, double t) const {
        return amplitude * (swing * std::exp(Complex(0.0, angular_frequency * t))).real();
    }
    double amplitude, angular_frequency;
};

/// The fields that do not depend on y, from a solution of either kind.
template <class Response>
Row add_surface(Row row, const Response& response, const Moment& moment, double t) {
    const Slab& slab = response.slab();
    return row.add(slab.surface_temperature() + moment.of(response.surface_temperature(), t))
        .add(slab.burn_rate() * (1.0 + moment.of(response.burn_rate(), t)))
        .add(std::abs(response.burn_rate()))
        .add(std::arg(response.burn_rate()));
}

Domain below_surface(const Given& given) {
    return {.y = {-given.number("depth"), 0.0}};
}

}  // namespace

TruthEntry flux_response_entry() {
    return {.name = "flux-response",
            .description =
                "A rigid slab that burns by its law under a flame that swings a little, seen from "
                "its surface, y = 0: temperature and burn rate, exact to second order in the "
                "amplitude.",
            .source =
                "paper eq. 7 and 11 without mechanics, linearised about the steady slab; "
                "reference/flux_response.hpp",
            .parameters = rigid_parameters(),
            .fields = rigid_fields(),
            .examples = lattice({0.0, 120e-6}, {-300e-6, 0.0}),
            .example_time = 1e-3,
            .build = [](const Given& given) {
                const FluxResponse response(conditions_of(given), given.number("frequency"));
                return pointwise(
                    rigid_fields(), below_surface(given),
                    [response, moment = Moment(given)](const Eigen::Vector2d& at, double t) {
                        const double y = std::min(at.y(), 0.0);
                        return add_surface(Row().add(response.slab().temperature(y) +
                                                     moment.of(response.temperature(y), t)),
                                           response, moment, t);
                    });
            }};
}

TruthEntry flux_response_shooting_entry() {
    return {.name = "flux-response-shooting",
            .description =
                "The same slab where heat expands it, by shooting on the linearised equations: "
                "temperature, burn rate and velocity.",
            .source =
                "paper eq. 7, 11, 34 and 38 in one dimension, linearised about the Eulerian slab; "
                "reference/flux_response_shooting.hpp",
            .parameters = expanding_parameters(),
            .fields = expanding_fields(),
            .examples = lattice({0.0, 120e-6}, {-300e-6, 0.0}),
            .example_time = 1e-3,
            .build = [](const Given& given) {
                SlabConditions conditions = conditions_of(given);
                conditions.model = SlabModel::eulerian;
                if (given.text("thermal_stress") == "alpha K")
                    conditions.thermal_stress = ThermalStress::alpha_k;
                if (given.text("heat_capacity") == "c_v")
                    conditions.heat_capacity = HeatCapacity::constant_volume;
                const FluxResponseShooting response(conditions, given.number("frequency"));
                auto evaluate = [response, moment = Moment(given)](
                                    std::span<const Eigen::Vector2d> points, double t) {
                    std::vector<double> y;
                    for (const Eigen::Vector2d& point : points)
                        y.push_back(std::min(point.y(), 0.0));
                    const auto steady = response.slab().states(y);
                    const auto swing = response.fluctuations(y);
                    Eigen::MatrixXd table(Eigen::Index(y.size()), 7);
                    for (size_t k = 0; k < y.size(); ++k) {
                        const Row row = add_surface(
                            Row().add(steady[k].temperature + moment.of(swing[k].temperature, t)),
                            response, moment, t);
                        table.row(Eigen::Index(k)).head(5) =
                            Eigen::Map<const Eigen::RowVectorXd>(row.values().data(), 5);
                        table.row(Eigen::Index(k)).tail(2) << 0.0,
                            steady[k].velocity + moment.of(swing[k].velocity, t);
                    }
                    return table;
                };
                return Truth(expanding_fields(), below_surface(given), evaluate);
            }};
}

}  // namespace crawford::reference
