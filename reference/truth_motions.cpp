#include "reference/exact_motions.hpp"
#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"
#include "reference/truth_materials.hpp"

namespace crawford::reference {

namespace {

const char* const source = "followed in closed form; reference/exact_motions.hpp";

std::vector<Eigen::Vector2d> square() {
    return lattice({-100e-6, 100e-6}, {-240e-6, 0.0});
}

Fields strain_fields() {
    return symmetric_fields("strain", "1", "Green-St. Venant strain E");
}

Fields plane_stress_fields() {
    return symmetric_fields("stress", "Pa", "Cauchy stress in the plane, tension positive");
}

Row row(const Eigen::Vector2d& at, const Eigen::Vector2d& velocity, const Eigen::Vector2d& origin,
        const Eigen::Matrix2d& gradient) {
    return Row().add(velocity).add(origin).add(Eigen::Vector2d(at - origin)).add(gradient);
}

/// Velocity, map, F and E of a motion whose F is not the same everywhere.
template <class Motion>
Truth strained_truth(const Motion& motion, const Domain& domain) {
    return pointwise(joined({motion_fields(), strain_fields()}), domain,
                     [motion](const Eigen::Vector2d& at, double t) {
                         return row(at, motion.velocity(at), motion.origin(at, t),
                                    motion.deformation_gradient(at, t))
                             .add_symmetric(motion.strain(at, t));
                     });
}

Truth rotation_truth(const Given& given) {
    const RigidRotation motion(given.number("rate"),
                               {given.number("centre_x"), given.number("centre_y")});
    Eigen::Matrix2d initial;
    initial << given.number("initial_stress_xx"), given.number("initial_stress_xy"),
        given.number("initial_stress_xy"), given.number("initial_stress_yy");
    return pointwise(joined({motion_fields(), plane_stress_fields()}), {},
                     [=](const Eigen::Vector2d& at, double t) {
                         return row(at, motion.velocity(at), motion.origin(at, t),
                                    motion.deformation_gradient(t))
                             .add_symmetric(motion.stress(initial, t));
                     });
}

Truth shear_truth(const Given& given) {
    const SimpleShear motion(given.number("rate"), given.number("base"));
    const double modulus = material_of(given).shear_modulus;
    return pointwise(joined({motion_fields(), strain_fields(), plane_stress_fields()}), {},
                     [=](const Eigen::Vector2d& at, double t) {
                         return row(at, motion.velocity(at), motion.origin(at, t),
                                    motion.deformation_gradient(t))
                             .add_symmetric(motion.strain(t))
                             .add_symmetric(motion.stress(modulus, t));
                     });
}

}  // namespace

TruthEntry rigid_rotation_entry() {
    return {.name = "rigid-rotation",
            .description =
                "A body that turns about a point, counter-clockwise, and the even "
                "stress that turns with it.",
            .source = source,
            .parameters = {number("rate", "rad/s", 100.0, limits::finite, "angular velocity"),
                           number("centre_x", "m", 0.0, limits::finite, "of the rotation"),
                           number("centre_y", "m", -120e-6, limits::finite, "of the rotation"),
                           number("initial_stress_xx", "Pa", 1e6, limits::finite, "at time 0"),
                           number("initial_stress_yy", "Pa", -1e6, limits::finite, "at time 0"),
                           number("initial_stress_xy", "Pa", 5e5, limits::finite, "at time 0")},
            .fields = joined({motion_fields(), plane_stress_fields()}),
            .examples = square(),
            .example_time = 1e-3,
            .build = rotation_truth};
}

TruthEntry simple_shear_entry() {
    return {.name = "simple-shear",
            .description =
                "Layers that slide over each other, v = (rate (y - base), 0), from a "
                "state without stress, and the stress of a hypoelastic solid under the "
                "Jaumann rate.",
            .source = "Dienes, Acta Mechanica 32 (1979); reference/exact_motions.hpp",
            .parameters =
                joined(material_parameters("binder", {"shear_modulus"}),
                       {number("rate", "1/s", 100.0, limits::finite, "gamma_t"),
                        number("base", "m", -240e-6, limits::finite, "y0, the layer that stays")}),
            .fields = joined({motion_fields(), strain_fields(), plane_stress_fields()}),
            .examples = square(),
            .example_time = 1e-3,
            .build = shear_truth};
}

TruthEntry uniaxial_flow_entry() {
    return {.name = "uniaxial-flow",
            .description =
                "Material that streams upward and stretches, v = speed ((y - "
                "base)/length)^2, above the layer that stays.",
            .source = source,
            .parameters = {number("speed", "m/s", 0.01, limits::finite,
                                  "V: the velocity a length above the base"),
                           number("base", "m", -240e-6, limits::finite, "y0"),
                           number("length", "m", 240e-6, limits::positive, "L")},
            .fields = joined({motion_fields(), strain_fields()}),
            .examples = square(),
            .example_time = 1e-3,
            .build = [](const Given& given) {
                const double base = given.number("base");
                const UniaxialFlow flow(given.number("speed"), base, given.number("length"));
                return strained_truth(flow, {.y = {.from = base}});
            }};
}

TruthEntry wavy_shear_entry() {
    return {.name = "wavy-shear",
            .description =
                "Columns that slide beside each other while all drift sideways, v = "
                "(drift, speed sin(2 pi x/width)).",
            .source = source,
            .parameters = {number("drift", "m/s", 0.01, limits::finite, "U"),
                           number("speed", "m/s", 0.01, limits::finite, "V"),
                           number("width", "m", 240e-6, limits::positive, "period in x")},
            .fields = joined({motion_fields(), strain_fields()}),
            .examples = square(),
            .example_time = 1e-3,
            .build = [](const Given& given) {
                return strained_truth(
                    WavyShear(given.number("drift"), given.number("speed"), given.number("width")),
                    {});
            }};
}

}  // namespace crawford::reference
