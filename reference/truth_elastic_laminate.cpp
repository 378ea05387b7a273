#include "reference/elastic_laminate.hpp"
#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"
#include "reference/truth_materials.hpp"

namespace crawford::reference {

namespace {

Fields laminate_fields() {
    return joined({vector_fields("displacement", "m", "(u, v)"), stress_fields()});
}

Truth as_truth(const ElasticLaminate& laminate) {
    return pointwise(laminate_fields(), {}, [laminate](const Eigen::Vector2d& at, double) {
        return Row().add(laminate.displacement(at.x(), at.y())).add(laminate.stress(at.x()));
    });
}

}  // namespace

TruthEntry elastic_laminate_entry() {
    return {
        .name = "elastic-laminate",
        .description =
            "A periodic laminate of two materials, layers along y, a strip of the inner "
            "one about x = 0; strained along the layers and sheared, plane strain.",
        .source =
            "small-strain elasticity, even in each layer: continuous sigma_xx, sigma_xy and "
            "displacement; reference/elastic_laminate.hpp",
        .parameters = joined(
            joined(material_parameters("binder", elastic_properties(), "inner_"),
                   material_parameters("AP", elastic_properties(), "outer_")),
            {number("width", "m", 240e-6, limits::positive, "period in x"),
             number("strip", "m", 60e-6, limits::positive, "width of the inner layer, below width"),
             number("axial_strain", "1", -1e-3, limits::finite, "eps_yy, common to all layers"),
             number("shear", "1", 0.0, limits::finite, "G: u grows by G y")}),
        .fields = laminate_fields(),
        .examples = lattice({-120e-6, 100e-6}, {0.0, 240e-6}),
        .build = [](const Given& given) {
            return as_truth(ElasticLaminate({.inner = material_of(given, "inner_"),
                                             .outer = material_of(given, "outer_"),
                                             .period = given.number("width"),
                                             .strip = given.number("strip"),
                                             .axial_strain = given.number("axial_strain"),
                                             .shear = given.number("shear")}));
        }};
}

}  // namespace crawford::reference
