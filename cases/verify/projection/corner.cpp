/// # Corner: does stress grow towards the corner of two materials as elasticity says?
///
/// Where the interface of AP and binder meets the surface, a quarter plane of each, elasticity
/// wants a stress that is infinite: r^(lambda - 1), lambda = 0.59502
/// (reference/williams_corner.hpp, the zero of a determinant, confirmed by Bogy's closed form). No
/// grid follows that to r = 0, but a few cells away the exponent is there to be read. It says that
/// the contrast of the moduli, the incompressibility of the binder (a binder with Poisson ratio 0.3
/// would have 0.71), the free surface and the bond are all right at once, and it explains every
/// order that the studies of the sandwich find.
///
/// A cold sandwich is pressed in one step. The pressure alone makes an even field, close to
/// hydrostatic and known in closed form; it is taken off. What is left is K r^(lambda - 1) and
/// then, by the next zero of Bogy's function, r^(0.67 +- 0.81i). It is read along a ray of AP 15
/// degrees below the surface, where that next term is smallest: between 2 and 6 um the exact field
/// (reference/elastic_sandwich.hpp) has the exponent -0.406. Along 45 degrees it would be -0.422.
/// The window is 120 um deep, a quarter of the usual depth, for four times as many cells across.

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <vector>

#include "cases/registry.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "reference/williams_corner.hpp"
#include "reports/order.hpp"
#include "solver/run/loop.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::between;

constexpr double pressure = 2.0 * MPa;
constexpr double interface = 30.0 * um;

Scene pressed(int nx) {
    Scene scene = sandwich({"domain.clustering=0", "domain.depth=120 um"});
    scene.domain.nx = nx;
    scene.domain.ny = nx / 2;
    scene.physics = {.heat = false, .reference_map = false, .regression = Regression::none};
    scene.numerics.viscous_time.reset();  // it follows what burns
    return scene;
}

/// Size of the in-plane stress [Pa] above the even field, interpolated between the centres of
/// cells.
class SingularStress {
public:
    explicit SingularStress(int nx)
        : simulation_(pressed(nx)),
          even_(reference::even_stress(reference::ap(), reference::binder(), pressure)) {
        run_steps(simulation_, 1);
    }

    /// At a distance r from the corner, in AP, `angle` below the surface.
    double operator()(double r, double angle) const {
        const Grid& grid = simulation_.grid();
        const double x = interface + r * std::cos(angle);
        const double y = -r * std::sin(angle);
        const double column = (x - grid.x(0)) / grid.dx() - 0.5;
        const double row = (y + grid.depth()) / grid.height(0) - 0.5;
        const int i = int(std::floor(column));
        const int j = int(std::floor(row));
        const double a = column - i;
        const double b = row - j;
        const Eigen::Vector3d s = (1 - b) * ((1 - a) * at(i, j) + a * at(i + 1, j)) +
                                  b * ((1 - a) * at(i, j + 1) + a * at(i + 1, j + 1));
        return std::sqrt(s[0] * s[0] + s[1] * s[1] + 2.0 * s[2] * s[2]);
    }

private:
    Eigen::Vector3d at(int i, int j) const {
        const PlaneStress s = simulation_.state().stress.mean(i, j);
        return {s.s11 - even_, s.s22 + pressure, s.s12};
    }

    Simulation simulation_;
    double even_;
};

/// Slope of log(stress) against log(r).
double exponent(const SingularStress& stress) {
    constexpr double angle = 15.0 * boost::math::constants::degree<double>();
    std::vector<reports::Level> levels;
    for (int k = 0; k <= 8; ++k) {
        const double r = 2.0 * um * std::pow(3.0, k / 8.0);
        levels.push_back({.grid = k, .h = r, .error = stress(r, angle)});
    }
    return reports::Convergence(levels).fit();
}

reports::Measurement measure(int nx) {
    reports::Measurement result(1.0 / nx);
    result.value("exponent of stress", exponent(SingularStress(nx)));
    return result;
}

std::vector<reports::Study> studies() {
    const double williams = reference::corner_exponent(reference::ap(), reference::binder()) - 1.0;
    reports::Study study("corner");
    study.refines("columns", {256, 512})
        .measure(measure)
        .covers({term::elasticity, term::equilibrium, term::traction, term::elastic_interface,
                 term::incompressibility})
        .bound("exponent of stress", 256, between(williams - 0.03, williams + 0.03),
               "read from 2 cells on")
        .bound("exponent of stress", 512, between(williams - 0.015, williams + 0.015),
               "read from 4 cells on; the next term moves it by 0.001, the cells by 0.004");
    return {study};
}

const Registered here{{.name = "corner",
                       .figure = "-",
                       .shows = "singular stress where AP, binder and gas meet",
                       .cost = {.verify = 3.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
