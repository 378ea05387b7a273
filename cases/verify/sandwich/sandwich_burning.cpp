/// # Burning sandwich: does it burn without ringing?
///
/// Where interface and surface meet, the stress of a sandwich is singular, and the binder is nearly
/// incompressible. That is where codes zigzag: velocities that alternate from node to node,
/// pressures like a checkerboard, strains that tell more of the grid than of the solid. Here the
/// thermo-mechanical sandwich burns for 25 ms, 75 um, on 64 and on 128 columns (96 rows,
/// clustering 2), and what could ring is measured.
///
/// The measure is the fourth difference along a row, relative to the values themselves: 1 for a
/// pure zigzag, 0 for anything smooth. It is taken inside one material, because at the interface
/// the solid has true kinks and jumps, and for velocity and pressure beyond three nodes of the
/// corner, within which no bilinear element resolves the singularity. Peak strain grows with each
/// refinement; its mean over 5 um of binder about the peak must not.

#include "cases/registry.hpp"
#include "cases/scenes/sandwich.hpp"
#include "cases/scenes/sandwich_measures.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "reports/alternation.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::alternation;
using reports::alternation_of_half;
using reports::at_most;
using reports::between;

constexpr int nodes_about_the_corner = 3;
constexpr int rows_below_the_surface = 24;

Scene scene(int columns) {
    Scene result = sandwich({"time.end=0.025 s", "time.step=80 us"});
    result.domain.nx = columns;
    return result;
}

/// Columns of cells that the binder's half takes.
int binder_columns(const Snapshot& snapshot) {
    int columns = 0;
    while (snapshot.material(columns, 0) < 0.5) ++columns;
    return columns;
}

/// One component along the surface, on the nodes strictly inside each material: the worse of the
/// two.
template <class Read>
double surface_alternation(const Snapshot& snapshot, double sign, const Read& read) {
    const int interface = binder_columns(snapshot);
    std::vector<double> binder;
    std::vector<double> solid;
    for (int i = 0; i < interface; ++i) binder.push_back(read(i));
    for (int i = interface + 1; i < snapshot.position.columns(); ++i) solid.push_back(read(i));
    return std::max(alternation_of_half(binder, sign), alternation(solid));
}

double displacement_alternation(const Snapshot& snapshot) {
    const int top = snapshot.position.rows() - 1;
    const auto up = [&](int i) {
        return snapshot.position(i, top).y() - snapshot.reference_map(i, top).y();
    };
    return surface_alternation(snapshot, 1.0, up);
}

/// The largest alternation of a binder row, from the axis to three nodes before the corner.
template <class Read>
double binder_alternation(const Snapshot& snapshot, int rows, const Read& read) {
    const int columns = binder_columns(snapshot) - nodes_about_the_corner;
    double largest = 0.0;
    for (int j = rows - rows_below_the_surface; j < rows; ++j) {
        std::vector<double> row;
        for (int i = 0; i < columns; ++i) row.push_back(read(i, j));
        largest = std::max(largest, alternation_of_half(row, 1.0));
    }
    return largest;
}

double strain_about_the_peak(const Snapshot& snapshot) {
    return peak(snapshot, snapshot.strain_norm, 5.0 * um).mean;
}

reports::Measurement measure(int columns) {
    const Snapshot last = kept_burn(scene(columns), {})->last;
    const Snapshot coarse = kept_burn(scene(64), {})->last;
    const auto v = [&](int i, int j) { return last.velocity(i, j).y(); };
    const auto p = [&](int i, int j) { return last.pressure(i, j); };
    return reports::Measurement(1.0 / columns)
        .value("surface displacement, alternation", displacement_alternation(last))
        .value("velocity, alternation", binder_alternation(last, last.velocity.rows(), v))
        .value("binder pressure, alternation", binder_alternation(last, last.pressure.rows(), p))
        .value("strain about the peak", strain_about_the_peak(last))
        .value("strain about the peak, against 64 columns",
               strain_about_the_peak(last) / strain_about_the_peak(coarse));
}

std::vector<reports::Study> studies() {
    reports::Study study("sandwich-burning");
    study.refines("columns", {64, 128})
        .measure(measure)
        .covers({term::incompressibility, term::elastic_interface, term::equilibrium,
                 term::traction, term::deformation});
    for (const int columns : {64, 128})
        study
            .bound("surface displacement, alternation", columns, at_most(0.01),
                   "a ripple one would see; 0.011 on 64 columns without viscosity and patches")
            .bound("velocity, alternation", columns, at_most(0.05),
                   "0.80 on 64 columns and 0.36 on 128 without viscosity and patches")
            .bound("binder pressure, alternation", columns, at_most(0.02),
                   "0.08 on 64 columns and 0.06 on 128 without patches");
    study.bound("strain about the peak, against 64 columns", 128, between(0.95, 1.05),
                "a mean over a fixed radius converges where the peak does not");
    return {study};
}

const Registered here{
    {.name = "sandwich-burning",
     .figure = "-",
     .shows = "burning sandwich: no zigzag, no checkerboard, strain that converges",
     .physics = {physics::sandwich},
     .cost = {.verify = 12.0},
     .studies = studies}};

}  // namespace

}  // namespace crawford
