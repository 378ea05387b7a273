#include "reference/manufactured_elastic_body.hpp"
#include "reference/manufactured_elastic_strip.hpp"
#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"
#include "reference/truth_materials.hpp"
#include "reference/truth_of.hpp"

namespace crawford::reference {

namespace {

ElasticModuli moduli_of(const Given& given, const std::string& prefix = "") {
    const Material material = material_of(given, prefix);
    return {.bulk = material.bulk_modulus, .shear = material.shear_modulus};
}

Fields elastic_fields() {
    return joined({vector_fields("displacement", "m", "(u, v)"), stress_fields(),
                   vector_fields("body_force", "N/m^3", "b = -div sigma")});
}

template <class Elastic>
Row elastic_row(const Elastic& elastic, const Eigen::Vector2d& at) {
    return Row()
        .add(elastic.displacement(at.x(), at.y()))
        .add(elastic.stress(at.x(), at.y()))
        .add(elastic.body_force(at.x(), at.y()));
}

/// Where the surface is, and what a traction must do there.
Fields loaded_fields() {
    return joined({elastic_fields(), surface_field(),
                   vector_fields("surface_traction", "Pa", "sigma n on the surface at x")});
}

WavyBody body_of(const Given& given) {
    return {.width = given.number("width"),
            .depth = given.number("depth"),
            .height = given.number("height"),
            .phase = given.number("phase")};
}

ManufacturedElasticity chosen(const Given& given, const WavyBody& body) {
    const double amplitude = given.number("amplitude");
    const ElasticModuli moduli = moduli_of(given);
    if (given.text("waves") == "clamped") return {ClampedWaves{body, amplitude}, moduli};
    if (given.text("waves") == "rolling")
        return {RollingWaves{body, moduli, amplitude, given.number("pressure")}, moduli};
    const SurfaceLoad load{.normal = given.number("load_normal"),
                           .vertical = given.number("load_vertical")};
    return {PressedWaves{body, moduli, amplitude, load}, moduli};
}

/// Smooth beyond its edges, and told a tenth of the depth beyond them.
Truth body_truth(const Given& given) {
    const WavyBody body = body_of(given);
    body.require();
    const ManufacturedElasticity elastic = chosen(given, body);
    const Domain around{.y = {-1.1 * body.depth, 0.1 * body.depth},
                        .surface = [body](double x, double) { return body.surface(x); }};
    return pointwise(loaded_fields(), around, [=](const Eigen::Vector2d& at, double) {
        const double surface = body.surface(at.x());
        return elastic_row(elastic, at)
            .add(surface)
            .add(traction(elastic.stress(at.x(), surface), body.slope(at.x())));
    });
}

Truth strip_truth(const Given& given) {
    const ElasticStrip strip{.width = given.number("width"),
                             .strip = given.number("strip"),
                             .depth = given.number("depth"),
                             .outer = moduli_of(given, "outer_"),
                             .inner = moduli_of(given, "inner_"),
                             .stress = given.number("stress")};
    const ManufacturedStrip elastic(strip);
    return pointwise(loaded_fields(), {.y = {-strip.depth, 0.0}},
                     [elastic](const Eigen::Vector2d& at, double) {
                         return elastic_row(elastic, at)
                             .add(0.0)
                             .add(traction(elastic.stress(at.x(), 0.0), 0.0));
                     });
}

std::vector<Parameter> body_parameters() {
    return joined(material_parameters("AP", elastic_properties()),
                  {text("waves", "clamped", {"clamped", "rolling", "pressed"},
                        "clamped; on rollers; or clamped and in equilibrium with load_normal and "
                        "load_vertical"),
                   number("width", "m", 240e-6, limits::positive, "period in x"),
                   number("depth", "m", 240e-6, limits::positive, "from the surface to the bottom"),
                   number("height", "m", 12e-6, limits::finite, "of the waves on the surface"),
                   number("phase", "rad", 0.7, limits::finite, "of these waves"),
                   number("amplitude", "m", 4e-6, limits::finite, "of the displacement"),
                   number("pressure", "Pa", 2e6, limits::finite, "on the bottom, on rollers"),
                   number("load_normal", "Pa", -2e6, limits::finite,
                          "on the surface per unit x along (-phi_x, 1), where pressed"),
                   number("load_vertical", "Pa", 0.0, limits::finite,
                          "on the surface per unit x along y, where pressed")});
}

}  // namespace

Truth truth_of(const ManufacturedElasticity& elastic) {
    return pointwise(elastic_fields(), {}, [elastic](const Eigen::Vector2d& at, double) {
        return elastic_row(elastic, at);
    });
}

Truth truth_of(const ManufacturedStrip& strip) {
    return pointwise(elastic_fields(), {},
                     [strip](const Eigen::Vector2d& at, double) { return elastic_row(strip, at); });
}

TruthEntry manufactured_elastic_body_entry() {
    return {.name = "manufactured-elastic-body",
            .description =
                "A smooth displacement of a body below a wavy surface, y = height "
                "cos(2 pi x/width + phase), and the loads under which it is the exact "
                "one; plane strain.",
            .source =
                "manufactured for small-strain elasticity, div sigma + b = 0; "
                "reference/manufactured_elastic_body.hpp",
            .parameters = body_parameters(),
            .fields = loaded_fields(),
            .examples = lattice({0.0, 200e-6}, {-220e-6, -20e-6}),
            .build = body_truth};
}

TruthEntry manufactured_elastic_strip_entry() {
    return {
        .name = "manufactured-elastic-strip",
        .description =
            "A displacement that is continuous with its traction across a strip "
            "about x = 0, stress of one size in both materials however different; "
            "clamped at the bottom, level surface y = 0, plane strain.",
        .source =
            "manufactured for small-strain elasticity, div sigma + b = 0; "
            "reference/manufactured_elastic_strip.hpp",
        .parameters = joined(joined(material_parameters("binder", elastic_properties(), "inner_"),
                                    material_parameters("AP", elastic_properties(), "outer_")),
                             {number("width", "m", 240e-6, limits::positive, "period in x"),
                              number("strip", "m", 60e-6, limits::positive, "below width"),
                              number("depth", "m", 120e-6, limits::positive, "of the bottom"),
                              number("stress", "Pa", 1e6, limits::positive,
                                     "size of the stress in both materials")}),
        .fields = loaded_fields(),
        .examples = lattice({-120e-6, 100e-6}, {-120e-6, 0.0}),
        .build = strip_truth};
}

}  // namespace crawford::reference
