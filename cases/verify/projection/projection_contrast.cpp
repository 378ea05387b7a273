/// # Projection across a contrast: does an interface cost accuracy, and does K >> mu lock?
///
/// A strip of soft material between stiff ones, the interfaces on grid lines. The displacement is
/// chosen (reference/manufactured_elastic_strip.hpp): continuous with its traction, as smooth as
/// the interface allows, a stress of the same size in both materials, nearly incompressible in the
/// strip as its K/mu grows. Its loads follow by automatic differentiation, and the solver has to
/// find it for ratios of mu from 1 to 1e8 and K/mu of the strip from 1 to 1e5. It is symmetric, so
/// half of it is solved.
///
/// Elements that meet at the interface each see a smooth displacement, so nothing should depend on
/// the contrast: 2 in v and in the stress at cell centres, each material by itself, as the soft one
/// moves 1e8 times as far. B-bar's pressures, three to a patch of 2 x 2 cells, form a stable pair
/// with the velocities, so its error must not grow with K/mu either. The paper's fully integrated
/// element has no such proof and locks: how much is stated beside it.
///
/// One place is worse: where a face meets the surface the traction has a kink, and loads taken by
/// trapezoids leave a point force of h^2/6 times it on the corner. Its stress, h^2/r, is of first
/// order in the cell beside the corner (so no Linf is gated) and h^2 sqrt(log 1/h) in L2: 1.98.
/// Cells further off than 0.15 show 2.00.
///
/// Round-off: the solve loses K/mu (h/L)^-2 of the 16 digits, 1e-6 of v at worst here; two direct
/// solvers differ by less than 1e-9 of the stress. The finest grid reaches 1e-3, so no gate sees
/// it. The ratio of mu costs nothing, as it only scales rows and columns.

#include <fmt/format.h>

#include <array>

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/projection/elastic_step.hpp"
#include "reference/manufactured_elastic_strip.hpp"
#include "reference/truth_of.hpp"

namespace crawford {

namespace {

using namespace units;
using reference::ElasticStrip;
using reference::ManufacturedStrip;
using reports::at_least;
using reports::between;
using reports::expect;
using reports::Norm;

constexpr double soft_shear = 2.5 * MPa;

ElasticStrip strip(double contrast, double incompressibility) {
    const double stiff = contrast * soft_shear;
    return {.width = 1.0,
            .strip = 0.25,
            .depth = 0.5,
            .outer = {.bulk = 1.2 * stiff, .shear = stiff},
            .inner = {.bulk = incompressibility * soft_shear, .shear = soft_shear},
            .stress = 1.0 * MPa};
}

Material material(const reference::ElasticModuli& moduli) {
    Material result;
    result.bulk_modulus = moduli.bulk;
    result.shear_modulus = moduli.shear;
    return result;
}

Scene scene(const ElasticStrip& strip, Element element, int cells) {
    Scene scene;
    scene.domain = {.width = strip.width,
                    .depth = strip.depth,
                    .nx = cells,
                    .ny = cells / 2,
                    .clustering = 0.0,
                    .half = true};
    scene.morphology = {.shape = Sandwich{strip.strip},
                        .materials = {material(strip.outer), material(strip.inner)}};
    scene.bottom.support = Support::clamped;
    scene.numerics.element = element;
    scene.numerics.viscous_time = 0.0;
    return scene;
}

/// Errors in the strip and beside it.
reports::Measurement errors(const ElasticStrip& strip, Element element, int cells) {
    const ManufacturedStrip truth(strip);
    const ProjectionSources sources{
        .body_force = [&](double x, double y, double) { return truth.body_force(x, y); },
        .traction = [&](double x, double y,
                        double) { return reference::traction(truth.stress(x, y), 0.0); }};
    const ElasticStep step(
        scene(strip, element, cells), [](double) { return 0.0; }, sources);
    const auto inside = [&](double x, double) { return x < 0.5 * strip.strip; };
    const auto beside = [&](double x, double) { return x >= 0.5 * strip.strip; };
    const reference::Truth exact = reference::truth_of(truth);
    reports::Measurement result(1.0 / cells);
    step.compare_displacement("v in the strip", exact, result, inside);
    step.compare_displacement("v beside it", exact, result, beside);
    step.compare_stress(" in the strip", exact, result, inside);
    step.compare_stress(" beside it", exact, result, beside);
    return result;
}

constexpr std::array quantities{"v in the strip", "v beside it", "stress in the strip",
                                "pressure in the strip", "stress beside it"};

double relative(const reports::Measurement& errors, const std::string& quantity) {
    const auto found = errors.error_of(quantity, Norm::L2).value();
    return found.error / found.scale;
}

std::string at(const std::string& quantity, double incompressibility) {
    return fmt::format("{}, K/mu = {:.0e}", quantity, incompressibility);
}

std::string q1_over_bbar(double incompressibility) {
    return at("v in the strip, error of q1 over B-bar's", incompressibility);
}

std::string growth(const std::string& quantity) {
    return quantity + ", error at K/mu = 1e5 over that at 1e2";
}

constexpr std::array incompressibilities{1.0, 1e2, 1e5};
constexpr int compared = 128;  ///< the grid on which elements and K/mu are compared

reports::Measurement measure(double contrast, int cells) {
    reports::Measurement result(1.0 / cells);
    std::vector<reports::Measurement> bbar;
    for (const double k : incompressibilities) {
        bbar.push_back(errors(strip(contrast, k), Element::bbar, cells));
        for (const auto quantity : quantities) {
            const auto found = bbar.back().error_of(quantity, Norm::L2).value();
            result.error(at(quantity, k), Norm::L2, found.error, found.scale);
        }
    }
    if (cells != compared) return result;
    for (const auto quantity : quantities)
        result.value(growth(quantity),
                     relative(bbar.back(), quantity) / relative(bbar[1], quantity));
    for (const auto* run : {&bbar.front(), &bbar.back()}) {
        const double k = incompressibilities[size_t(run - bbar.data())];
        const auto q1 = errors(strip(contrast, k), Element::q1, cells);
        result.value(q1_over_bbar(k),
                     relative(q1, "v in the strip") / relative(*run, "v in the strip"));
    }
    return result;
}

reports::Study study(double contrast) {
    const auto second = expect(2.0).within(0.1).from(64);
    reports::Study study(fmt::format("projection-contrast, mu ratio {:.0e}", contrast));
    study.refines("cells", {32, 64, 128, 256})
        .measure([=](int cells) { return measure(contrast, cells); })
        .covers({term::elastic_interface, term::incompressibility, term::equilibrium});
    for (const double k : incompressibilities)
        for (const auto quantity : quantities)
            study.gate(
                at(quantity, k), Norm::L2, second,
                "each element sees a smooth displacement; 32 has but 4 columns in the strip");
    for (const auto quantity : quantities)
        study.bound(
            growth(quantity), compared, between(0.9, 1.1),
            "stable pressures: beyond K >> mu the error is that of the incompressible limit");
    study
        .bound(q1_over_bbar(1.0), compared, between(0.5, 2.0),
               "nothing to lock: both interpolate alike")
        .bound(q1_over_bbar(1e5), compared, at_least(50.0),
               "K/mu (h/a)^2 = 400: locked, q1 misses most of v; B-bar is off by 2 (h/a)^2");
    return study;
}

/// The faces of the strip cut patches of 2 x 2 cells: three columns to the strip, then 5, 9, 17.
reports::Study cut_patches() {
    const auto second = expect(2.0).within(0.1).from(40);
    reports::Study study("projection-contrast, faces between cells of a patch");
    study.refines("cells", {24, 40, 72, 136})
        .measure([](int cells) { return errors(strip(1e4, 1e5), Element::bbar, cells); })
        .covers({term::elastic_interface, term::incompressibility});
    for (const auto quantity : quantities)
        study.gate(quantity, Norm::L2, second, "single cells along a line are as good as patches");
    return study;
}

std::vector<reports::Study> studies() {
    return {study(1.0), study(1e2), study(1e4), study(1e8), cut_patches()};
}

const Registered here{{.name = "projection-contrast",
                       .figure = "-",
                       .shows = "projection across an interface against manufactured displacements",
                       .cost = {.verify = 10.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
