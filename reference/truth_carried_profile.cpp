#include "reference/carried_profile.hpp"
#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"

namespace crawford::reference {

namespace {

Fields profile_fields() {
    return joined({scalar_field("profile", "1", "what is carried, in the unit of amplitude"),
                   vector_fields("profile_gradient", "1/m", "its gradient"),
                   scalar_field("profile_rate", "1/s", "its change at a place that stays")});
}

ColumnShape column_of(const std::string& name) {
    if (name == "constant") return ColumnShape::constant;
    if (name == "bump") return ColumnShape::bump;
    return ColumnShape::exponential;
}

Truth profile_truth(const Given& given) {
    const CarriedProfile profile({.amplitude = given.number("amplitude"),
                                  .period = given.number("width"),
                                  .phase = given.number("phase"),
                                  .column = column_of(given.text("column")),
                                  .middle = given.number("middle"),
                                  .width = given.number("height")});
    const Eigen::Vector2d velocity(given.number("velocity_x"), given.number("velocity_y"));
    return pointwise(profile_fields(), {}, [=](const Eigen::Vector2d& at, double t) {
        const Eigen::Vector2d start = at - velocity * t;
        return Row()
            .add(profile.value(start))
            .add(profile.gradient(start))
            .add(profile.rate(start, velocity, Eigen::Vector2d::Zero()));
    });
}

}  // namespace

TruthEntry carried_profile_entry() {
    return {.name = "carried-profile",
            .description =
                "A smooth scalar profile, amplitude cos(2 pi x/width + phase) Y(y), that an "
                "even motion carries: profile(x - velocity t).",
            .source = "the advection equation; reference/carried_profile.hpp",
            .parameters =
                {number("amplitude", "1", 1.0, limits::finite, "in the unit of what is carried"),
                 number("width", "m", 240e-6, limits::not_negative, "period in x; 0 for no waves"),
                 number("phase", "rad", 0.0, limits::finite, "of the waves"),
                 text("column", "exponential", {"constant", "exponential", "bump"},
                      "Y = 1, exp((y - middle)/height) or exp(-((y - middle)/height)^2)"),
                 number("middle", "m", -120e-6, limits::finite, "of the profile along y"),
                 number("height", "m", 60e-6, limits::positive, "in which it changes along y"),
                 number("velocity_x", "m/s", 0.0, limits::finite, "of the motion"),
                 number("velocity_y", "m/s", 0.0045, limits::finite, "of the motion")},
            .fields = profile_fields(),
            .examples = lattice({-120e-6, 100e-6}, {-240e-6, 0.0}),
            .example_time = 1e-3,
            .build = profile_truth};
}

}  // namespace crawford::reference
