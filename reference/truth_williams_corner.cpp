#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"
#include "reference/truth_materials.hpp"
#include "reference/williams_corner.hpp"

namespace crawford::reference {

namespace {

Fields corner_fields() {
    return joined(
        {scalar_field("corner_exponent", "1", "lambda: stress grows as r^(lambda - 1)"),
         scalar_field("dundurs_alpha", "1", "contrast of the stiffnesses under uniaxial stress"),
         scalar_field("dundurs_beta", "1", "contrast of the bulk stiffnesses in the plane"),
         scalar_field("even_stress", "Pa",
                      "stress along the surface to which the singular field is added")});
}

Truth corner_truth(const Given& given) {
    const Material a = material_of(given, "inner_");
    const Material b = material_of(given, "outer_");
    const Dundurs contrast = dundurs(a, b);
    const double exponent = corner_exponent(a, b);
    const double stress = even_stress(a, b, given.number("pressure"));
    return pointwise(corner_fields(), {}, [=](const Eigen::Vector2d&, double) {
        return Row().add(exponent).add(contrast.alpha).add(contrast.beta).add(stress);
    });
}

}  // namespace

TruthEntry williams_corner_entry() {
    return {
        .name = "williams-corner",
        .description =
            "The corner where two bonded materials meet a free surface, plane "
            "strain: how stress grows beside it. The same at every point.",
        .source =
            "Williams, J. Appl. Mech. 19 (1952); Bogy, J. Appl. Mech. 35 (1968); "
            "reference/williams_corner.hpp",
        .parameters = joined(joined(material_parameters("AP", elastic_properties(), "inner_"),
                                    material_parameters("binder", elastic_properties(), "outer_")),
                             {number("pressure", "Pa", 2e6, limits::finite, "p_c on the surface")}),
        .fields = corner_fields(),
        .examples = {Eigen::Vector2d::Zero()},
        .build = corner_truth};
}

}  // namespace crawford::reference
