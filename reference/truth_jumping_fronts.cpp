#include <cmath>

#include "reference/jumping_front.hpp"
#include "reference/refracted_front.hpp"
#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"

namespace crawford::reference {

namespace {

Fields front_fields() {
    return joined({surface_field(), scalar_field("surface_slope", "1", "phi_x")});
}

std::vector<Eigen::Vector2d> along_x() {
    return lattice({-120e-6, 100e-6}, {0.0, 0.0});
}

Parameter rate(const std::string& name, double standard, const std::string& meaning) {
    return number(name, "m/s", standard, limits::positive, meaning);
}

}  // namespace

TruthEntry jumping_front_entry() {
    return {.name = "jumping-front",
            .description =
                "A surface that starts level over a strip and what is around it, each with a "
                "rate of its own, vertical interfaces: the faster side leads. y does not matter.",
            .source = "fastest paths (Fermat), head waves; reference/jumping_front.hpp",
            .parameters = {number("width", "m", 240e-6, limits::positive, "period in x"),
                           number("left", "m", -30e-6, limits::finite, "where the strip begins"),
                           number("right", "m", 30e-6, limits::finite,
                                  "where it ends, above left by less than width"),
                           rate("strip_rate", 0.002, "r_b in the strip"),
                           rate("outer_rate", 0.005, "r_b around it")},
            .fields = front_fields(),
            .examples = along_x(),
            .example_time = 5e-3,
            .build = [](const Given& given) {
                const JumpingFront front({.width = given.number("width"),
                                          .left = given.number("left"),
                                          .right = given.number("right"),
                                          .strip_rate = given.number("strip_rate"),
                                          .outer_rate = given.number("outer_rate")});
                return pointwise(
                    front_fields(), {.time = {.from = 0.0}},
                    [front](const Eigen::Vector2d& at, double t) {
                        return Row().add(front.height(at.x(), t)).add(front.slope(at.x(), t));
                    });
            }};
}

TruthEntry refracted_front_entry() {
    return {.name = "refracted-front",
            .description =
                "A surface that starts level and crosses a slower slab between inclined planes, "
                "one of a row or alone: refraction, arcs and head waves. y does not matter.",
            .source = "fastest paths (Fermat, Snell); reference/refracted_front.hpp",
            .parameters = {number("width", "m", 240e-6, limits::positive_or_infinite,
                                  "period in x, infinite for one slab"),
                           number("left", "m", -30e-6, limits::finite,
                                  "where its left face meets y = 0"),
                           number("right", "m", 30e-6, limits::finite, "and its right one"),
                           number("lean", "1", 0.25, limits::finite, "dx/dy of the faces"),
                           rate("slab_rate", 0.002, "r_b in the slab, the lower one"),
                           rate("outer_rate", 0.005, "r_b around it")},
            .fields = front_fields(),
            .examples = along_x(),
            .example_time = 5e-3,
            .build = [](const Given& given) {
                const RefractedFront front({.left = given.number("left"),
                                            .right = given.number("right"),
                                            .lean = given.number("lean"),
                                            .slab_rate = given.number("slab_rate"),
                                            .outer_rate = given.number("outer_rate"),
                                            .width = given.number("width")});
                const Interval alone{0.0, std::nextafter(front.alone_until(), 0.0)};
                return pointwise(
                    front_fields(), {.time = alone}, [front](const Eigen::Vector2d& at, double t) {
                        return Row().add(front.height(at.x(), t)).add(front.slope(at.x(), t));
                    });
            }};
}

}  // namespace crawford::reference
