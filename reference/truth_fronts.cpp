#include <cmath>

#include "reference/regressing_front.hpp"
#include "reference/truth_entries.hpp"
#include "reference/truth_fields.hpp"

namespace crawford::reference {

namespace {

const Domain from_the_start{.time = {.from = 0.0}};

std::vector<Parameter> wave_parameters() {
    return {number("amplitude", "m", 20e-6, limits::not_negative, "A of A cos(2 pi x/width)"),
            number("width", "m", 240e-6, limits::positive, "period in x"),
            number("burn_rate", "m/s", 0.0045, limits::positive, "r_b")};
}

RegressingWave wave_of(const Given& given) {
    return {given.number("amplitude"), given.number("width"), given.number("burn_rate")};
}

Fields smooth_fields() {
    return joined({surface_field(), scalar_field("surface_slope", "1", "phi_x")});
}

std::vector<Eigen::Vector2d> along_x() {
    return lattice({-120e-6, 100e-6}, {0.0, 0.0});
}

}  // namespace

TruthEntry regressing_wave_entry() {
    return {.name = "regressing-wave",
            .description =
                "A surface that starts as a cosine and recedes along its normal, by "
                "characteristics, until its crests kink. y does not matter.",
            .source = "paper eq. 9 with constant r_b; reference/regressing_front.hpp",
            .parameters = wave_parameters(),
            .fields = smooth_fields(),
            .examples = along_x(),
            .example_time = 5e-3,
            .build = [](const Given& given) {
                const RegressingWave wave = wave_of(given);
                const Interval before_kink{0.0, std::nextafter(wave.kink_time(), 0.0)};
                return pointwise(
                    smooth_fields(), {.time = before_kink},
                    [wave](const Eigen::Vector2d& at, double t) {
                        return Row().add(wave.height(at.x(), t)).add(wave.slope(at.x(), t));
                    });
            }};
}

TruthEntry regressing_wave_envelope_entry() {
    return {.name = "regressing-wave-envelope",
            .description =
                "The same surface before and after its crests kink, as the envelope of "
                "circles about the points of the first one. y does not matter.",
            .source =
                "Huygens' construction, which is the Hopf-Lax formula for paper eq. 9; "
                "reference/regressing_front.hpp",
            .parameters = wave_parameters(),
            .fields = surface_field(),
            .examples = along_x(),
            .example_time = 0.05,
            .build = [](const Given& given) {
                return pointwise(surface_field(), from_the_start,
                                 [wave = wave_of(given)](const Eigen::Vector2d& at, double t) {
                                     return Row().add(wave.envelope(at.x(), t));
                                 });
            }};
}

TruthEntry regressing_zigzag_entry() {
    return {
        .name = "regressing-zigzag",
        .description =
            "A surface that starts as a zigzag, lowest at x = 0, and recedes along its "
            "normal: valleys open into arcs, crests stay sharp. y does not matter.",
        .source = "Huygens' construction for paper eq. 9; reference/regressing_front.hpp",
        .parameters = {number("right", "1", 0.9, limits::positive,
                              "slope to the right of a valley"),
                       number("left", "1", 0.5, limits::positive, "steepness to the left of it"),
                       number("width", "m", 240e-6, limits::positive, "period in x"),
                       number("burn_rate", "m/s", 0.0045, limits::positive, "r_b")},
        .fields = surface_field(),
        .examples = along_x(),
        .example_time = 5e-3,
        .build = [](const Given& given) {
            const RegressingZigzag zigzag(given.number("right"), given.number("left"),
                                          given.number("width"), given.number("burn_rate"));
            return pointwise(surface_field(), from_the_start,
                             [zigzag](const Eigen::Vector2d& at, double t) {
                                 return Row().add(zigzag.height(at.x(), t));
                             });
        }};
}

}  // namespace crawford::reference
