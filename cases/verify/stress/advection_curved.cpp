/// # Advection under a curved surface: what does the slope cost?
///
/// As cases/verify/stress/advection.cpp, one step of `StressStep::predict` against the exact rate
/// of a carried profile; here a flow without spin carries it through a clustered grid under a
/// curved surface that moves at another rate at every place.
///
/// At the Gauss points of a cell it costs orders. The gradient of a bilinear velocity is second
/// order at the centre and first order off it, so the spin that turns the stress of a point misses
/// h times the second derivatives of the velocity, where it should see none. And all points take
/// the slope of the straight piece of surface over their cell, where their lattice has phi_x at
/// their own x: phi_xx (a - 1/2) dx u dsigma/dy, first order too, which a uniform velocity shows
/// alone (and a weak stress, for which WENO3 leaves h^3). Both are opposite at opposite points. In
/// the mean over a cell, and at the centre, where q1 and the pressure live, they cancel and leave
/// two. Half a window with mirrored sides must see what the whole one sees.

#include <cmath>
#include <numbers>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/stress/carried_stress.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::expect;
using reports::Norm;

constexpr double width = 240.0 * um;
constexpr double depth = 480.0 * um;
constexpr double speed = 5e-3 * m / s;
constexpr double wave_number = 2.0 * std::numbers::pi / width;

std::function<Domain(int)> window(bool half) {
    return [=](int cells) -> Domain {
        return {.width = width,
                .depth = depth,
                .nx = cells,
                .ny = cells,
                .clustering = 2.0,
                .half = half};
    };
}

/// A flow without spin under a curved surface that moves at another rate at every place.
Motion under_a_curved_surface() {
    const auto flow = [](const Vector& x) -> Vector {
        return 0.5 * speed * std::exp(wave_number * x.y()) *
               Vector(std::sin(wave_number * x.x()), -std::cos(wave_number * x.x()));
    };
    return {
        .surface = [](double x) { return 10.0 * um * std::cos(wave_number * x); },
        .surface_rate = [](double x) { return -speed * (1.0 + 0.3 * std::cos(wave_number * x)); },
        .velocity = flow};
}

/// Strong, so that WENO3 takes no difference for smooth; nothing of it is left at the bottom.
const reference::ProfileShape profile{.amplitude = 1e4 * MPa,
                                      .period = width,
                                      .column = reference::ColumnShape::bump,
                                      .middle = -0.125 * depth,
                                      .width = depth / 6.0};

/// What blows through under the same surface: no spin at all.
Motion uniform_under_a_curved_surface() {
    Motion motion = under_a_curved_surface();
    motion.velocity = [](const Vector&) { return Vector(speed, 0.0); };
    return motion;
}

reports::Study study_of(const std::string& name, const CarriedSetup& setup) {
    reports::Study study("advection-curved, " + name);
    study.refines("cells", {32, 64, 128, 256})
        .measure([setup](int cells) { return measure_rates(setup, cells); })
        .covers({term::stress_advection, term::slope, term::clustering, term::grid_motion});
    return study;
}

reports::Study spinless_flow(const std::string& name, bool half, Element element) {
    reports::Study study =
        study_of(name, {window(half), under_a_curved_surface(), profile, element});
    for (const auto* quantity : {carried::mean, carried::pressure})
        study
            .gate(quantity, Norm::L1, expect(2.0).or_better(0.1),
                  "slope of the cell, bilinear velocity: 2; inflections, h^3 log(1/h), are larger")
            .gate(quantity, Norm::Linf, expect(2.0).within(0.15).from(64), "both of these");
    if (element == Element::bbar)
        study.gate(carried::points, Norm::Linf, expect(1.0).or_better(0.1),
                   "the spin at a Gauss point: a bilinear gradient off the centre");
    return study;
}

reports::Study uniform_flow() {
    reference::ProfileShape weak = profile;
    weak.amplitude = 1e-3 * MPa;
    reports::Study study =
        study_of("uniform velocity, bbar", {window(false), uniform_under_a_curved_surface(), weak});
    study
        .gate(carried::points, Norm::Linf, expect(1.0).or_better(0.1).from(64),
              "phi_x of a Gauss point taken at the centre of its cell: dx phi_xx/sqrt(12)")
        .gate(carried::mean, Norm::Linf, expect(2.0).or_better(0.1).scattering(0.4),
              "cancels in the mean; coarse grids still show the three of WENO");
    return study;
}

std::vector<reports::Study> studies() {
    return {spinless_flow("bbar", false, Element::bbar), spinless_flow("q1", false, Element::q1),
            spinless_flow("half the window, bbar", true, Element::bbar), uniform_flow()};
}

const Registered here{{.name = "advection-curved",
                       .figure = "-",
                       .shows = "stress carried under a curved surface",
                       .cost = {.verify = 3.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
