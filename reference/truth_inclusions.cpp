#include "reference/circular_inclusion.hpp"
#include "reference/conducting_inclusion.hpp"
#include "reference/faded_inclusion.hpp"
#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"
#include "reference/truth_materials.hpp"
#include "reference/truth_of.hpp"

namespace crawford::reference {

namespace {

const Interval window{-120e-6, 115e-6};

std::vector<Parameter> elastic_parameters() {
    return joined(joined(material_parameters("AP", elastic_properties(), "inner_"),
                         material_parameters("binder", elastic_properties(), "outer_")),
                  {number("radius", "m", 40e-6, limits::positive, "of the disc"),
                   number("far_xx", "Pa", 1e6, limits::finite, "stress_xx at infinity"),
                   number("far_yy", "Pa", -2e6, limits::finite, "stress_yy at infinity"),
                   number("far_xy", "Pa", 1.5e6, limits::finite, "stress_xy at infinity")});
}

std::vector<Parameter> fading_parameters() {
    return {
        number("whole", "m", 55e-6, limits::positive,
               "the field is undiminished up to this distance, above radius"),
        number("gone", "m", 115e-6, limits::positive, "and gone from this one on, above whole")};
}

CircularInclusion inclusion(const Given& given) {
    return CircularInclusion({.inclusion = material_of(given, "inner_"),
                              .matrix = material_of(given, "outer_"),
                              .radius = given.number("radius"),
                              .far_xx = given.number("far_xx"),
                              .far_yy = given.number("far_yy"),
                              .far_xy = given.number("far_xy")});
}

Fields elastic_fields() {
    return joined({vector_fields("displacement", "m", "(u, v)"), stress_fields()});
}

Fields faded_fields() {
    return joined({elastic_fields(), vector_fields("body_force", "N/m^3", "b = -div sigma")});
}

Fields heat_fields() {
    return joined({temperature_field(), scalar_field("heat_source", "W/m^3", "q")});
}

Truth circular_truth(const Given& given) {
    return pointwise(
        elastic_fields(), {}, [disc = inclusion(given)](const Eigen::Vector2d& at, double) {
            return Row().add(disc.displacement(at.x(), at.y())).add(disc.stress(at.x(), at.y()));
        });
}

Truth faded_truth(const Given& given) {
    return truth_of(FadedInclusion(inclusion(given), given.number("whole"), given.number("gone")));
}

Truth conducting_truth(const Given& given) {
    const ConductingInclusion disc(
        {.inner_conductivity = material_of(given, "inner_").thermal_conductivity,
         .outer_conductivity = material_of(given, "outer_").thermal_conductivity,
         .radius = given.number("radius"),
         .temperature = given.number("far_temperature"),
         .gradient_x = given.number("gradient_x"),
         .gradient_y = given.number("gradient_y"),
         .whole = given.number("whole"),
         .gone = given.number("gone")});
    return pointwise(heat_fields(), {}, [disc](const Eigen::Vector2d& at, double) {
        return Row().add(disc.temperature(at.x(), at.y())).add(disc.source(at.x(), at.y()));
    });
}

}  // namespace

Truth truth_of(const FadedInclusion& disc) {
    return pointwise(faded_fields(), {}, [disc](const Eigen::Vector2d& at, double) {
        return Row()
            .add(disc.displacement(at.x(), at.y()))
            .add(disc.stress(at.x(), at.y()))
            .add(disc.body_force(at.x(), at.y()));
    });
}

TruthEntry circular_inclusion_entry() {
    return {.name = "circular-inclusion",
            .description =
                "A bonded disc about the origin in an unbounded matrix that is stressed "
                "far away, plane strain.",
            .source =
                "Kolosov and Muskhelishvili's potentials (Muskhelishvili, Some Basic "
                "Problems of the Mathematical Theory of Elasticity); "
                "reference/circular_inclusion.hpp",
            .parameters = elastic_parameters(),
            .fields = elastic_fields(),
            .examples = lattice(window, window),
            .build = circular_truth};
}

TruthEntry faded_inclusion_entry() {
    return {.name = "faded-inclusion",
            .description =
                "The circular inclusion whose displacement fades to zero inside a "
                "finite window, and the body force that this needs.",
            .source =
                "circular-inclusion times a polynomial of the distance; "
                "reference/faded_inclusion.hpp",
            .parameters = joined(elastic_parameters(), fading_parameters()),
            .fields = faded_fields(),
            .examples = lattice(window, window),
            .build = faded_truth};
}

TruthEntry conducting_inclusion_entry() {
    return {
        .name = "conducting-inclusion",
        .description =
            "Steady heat past a disc of another conductor about the origin, which fades "
            "to an even temperature, and the source that this needs.",
        .source =
            "dipole in an even gradient (Carslaw and Jaeger, Conduction of Heat in Solids); "
            "reference/conducting_inclusion.hpp",
        .parameters = joined(
            joined(joined(material_parameters("binder", {"thermal_conductivity"}, "inner_"),
                          material_parameters("AP", {"thermal_conductivity"}, "outer_")),
                   {number("radius", "m", 40e-6, limits::positive, "of the disc"),
                    number("far_temperature", "K", 400.0, limits::positive, "T0, far away"),
                    number("gradient_x", "K/m", 1e6, limits::finite, "of the undisturbed field"),
                    number("gradient_y", "K/m", 5e5, limits::finite, "of the undisturbed field")}),
            fading_parameters()),
        .fields = heat_fields(),
        .examples = lattice(window, window),
        .build = conducting_truth};
}

}  // namespace crawford::reference
