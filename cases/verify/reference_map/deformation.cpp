/// # Deformation: are F and E those of the map?
///
/// `deformation_gradient` and `green_strain` of the exact shift of motions whose particles can be
/// followed in closed form (reference/exact_motions.hpp), on a clustered grid under a curved
/// surface. Bilinear cells hold a linear map exactly, on any slope: F and E of a rotation and of a
/// simple shear come out to round-off. F of a shear tells F from its transpose and from its
/// inverse, and E from (F F^T - I)/2; a rotation tells E from any strain that is not objective. A
/// curved map is second order at the centres of the cells.

#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/verify/reference_map/followed_motion.hpp"
#include "reference/exact_motions.hpp"

namespace crawford {

namespace {

using namespace wavy_square;
using reports::between;
using reports::expect;
using reports::Norm;

reports::Measurement gradients(const FollowedMotion& motion, int cells) {
    const PrescribedMotion exact = body(motion, cells);
    reports::Measurement result(1.0 / cells);
    report_gradients(exact, shift_of(exact, motion), motion, result);
    return result;
}

reports::Study linear_map(const std::string& name, const FollowedMotion& motion) {
    reports::Study study("deformation, " + name);
    study.refines("cells", {64})
        .measure([motion](int cells) { return gradients(motion, cells); })
        .covers({term::deformation, term::slope, term::clustering});
    for (const auto* worst : {worst_f, worst_e})
        study.bound(worst, 64, between(0.0, 1e-12),
                    "bilinear cells hold a linear map: round-off of differences over a cell");
    return study;
}

reports::Study curved_map(const std::string& name, const FollowedMotion& motion) {
    reports::Study study("deformation, " + name);
    study.refines("cells", {32, 64, 128, 256})
        .measure([motion](int cells) { return gradients(motion, cells); })
        .covers({term::deformation, term::slope, term::clustering});
    for (const auto* quantity : {"F", "E"})
        study.gate(quantity, Norm::L2, expect(2.0).within(0.05), "centred differences at centres");
    return study;
}

std::vector<reports::Study> studies() {
    const double t = 0.1 * width / burn_rate;
    return {linear_map("rotation",
                       followed(reference::RigidRotation(0.5 / t, {0.1 * width, -0.4 * width}), t)),
            linear_map("simple shear", followed(reference::SimpleShear(0.5 / t, -0.3 * width), t)),
            curved_map("wavy shear",
                       followed(reference::WavyShear(0.7 * burn_rate, 0.5 * burn_rate, width), t)),
            curved_map("uniaxial flow",
                       followed(reference::UniaxialFlow(0.5 * burn_rate, -1.1 * width, width), t))};
}

const Registered here{{.name = "deformation",
                       .figure = "-",
                       .shows = "F and E of exact motions",
                       .cost = {.verify = 1.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
