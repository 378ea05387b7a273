/// # Burning pack: does a cell carry what its material cannot?
///
/// The grid follows the surface through a pack of 40 discs, so cells change from AP to binder and
/// back all the time. A cell that turns to binder and keeps the 100 MPa that AP held in shear can
/// relax it only through a huge strain: computations of packs blow up on this. Cells that an
/// interface cuts hold both materials by volume, in series, and what a cell can no longer hold it
/// gives up. The peak strain of the first 10 ms is then free of jumps from step to step, and the
/// shear stress of binder stays that of binder.
///
/// And the surface burns as what lies there burns: where a node is further than two cells from any
/// circle, its burn rate is the law of the one material, typed in independently. That holds for a
/// rigid pack as well, whose discs come to the surface in a solver that knows of nothing but heat, and
/// with either front.

#include <algorithm>
#include <cmath>

#include "base/process.hpp"
#include "base/source_tree.hpp"
#include "cases/registry.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "reference/material.hpp"
#include "solver/run/loop.hpp"
#include "solver/scene/read_scene.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

namespace {

using namespace units;
using reports::at_least;
using reports::at_most;

Scene pack(int columns) {
    Scene result = read_scene(source_path("cases/scenes/pack.toml"));
    result.domain.nx = columns;
    result.time.step = 50e-6;
    result.time.end = 0.01;
    return result;
}

Scene rigid_pack(int columns, Front front) {
    Scene result = pack(columns);
    result.numerics.front = front;
    result.physics.mechanics = false;
    result.physics.reference_map = false;
    return result;
}

double largest_strain(const Simulation& simulation) {
    return std::ranges::max(simulation.strain_norm().values());
}

/// Largest deviator of the cells that are binder and nothing else [Pa].
double largest_binder_shear(const Simulation& simulation) {
    const CellField material = simulation.material_fraction();
    double largest = 0.0;
    for (int i = 0; i < material.columns(); ++i)
        for (int j = 0; j < material.rows(); ++j) {
            if (material(i, j) > 0.0) continue;
            for (const auto& point : simulation.state().stress.deviator) {
                const Deviator& s = point(i, j);
                largest = std::max({largest, std::abs(s.s11), std::abs(s.s22), std::abs(s.s12)});
            }
        }
    return largest;
}

/// How far a point is inside the nearest disc, counting its images; negative outside [m].
double depth_in_disc(const Discs& pack, double width, const Vector& at) {
    double depth = -width;
    for (const Disc& disc : pack.discs) {
        const double x = std::remainder(at.x() - disc.x, width);
        const double y = std::remainder(at.y() - disc.y, pack.period);
        depth = std::max(depth, disc.radius - std::hypot(x, y));
    }
    return depth;
}

/// Nodes of the surface that burn in one material alone, and the worst of their burn rates.
struct Burning {
    int nodes = 0;
    double error = 0.0;  ///< relative
};

Burning compare_burning(const Simulation& simulation) {
    const Grid& grid = simulation.grid();
    const State& s = simulation.state();
    const auto& pack = std::get<Discs>(simulation.scene().morphology.shape);
    const SurfaceField rate = simulation.burn_rate();
    Burning result;
    for (int i = 0; i < grid.node_columns(); ++i) {
        const double depth = depth_in_disc(pack, grid.width(), {grid.x(i), s.surface[size_t(i)]});
        if (std::abs(depth) < 2.0 * grid.dx()) continue;
        const reference::Material burns = depth > 0.0 ? reference::ap() : reference::binder();
        const double law = burns.pyrolysis_prefactor *
                           std::exp(-burns.activation_temperature / s.temperature(i, grid.rows()));
        result.error = std::max(result.error, std::abs(rate[size_t(i)] / law - 1.0));
        ++result.nodes;
    }
    return result;
}

constexpr auto nodes = "nodes that burn in one material";
constexpr auto burning_error = "their burn rate / its law - 1";
constexpr auto jump = "peak strain, largest change in a step";
constexpr auto peak = "peak strain";
constexpr auto shear = "shear stress in binder [MPa]";

void add_burning(const Simulation& simulation, reports::Measurement& result) {
    const Burning burning = compare_burning(simulation);
    result.value(nodes, burning.nodes).value(burning_error, burning.error);
}

reports::Measurement burnt(int columns) {
    Simulation simulation(pack(columns));
    double largest_jump = 0.0;
    double strain = 0.0;
    double largest = 0.0;
    double in_binder = 0.0;
    const Observer watch = [&](const Simulation& burning, double) {
        const double now = largest_strain(burning);
        largest_jump = std::max(largest_jump, std::abs(now - strain));
        strain = now;
        largest = std::max(largest, now);
        in_binder = std::max(in_binder, largest_binder_shear(burning));
    };
    run_to_end(simulation, {watch});
    reports::Measurement result(1.0 / columns);
    add_burning(simulation, result);
    return result.value(jump, largest_jump).value(peak, largest).value(shear, in_binder / MPa);
}

reports::Measurement burnt_rigid(int columns, Front front) {
    Simulation simulation(rigid_pack(columns, front));
    run_to_end(simulation);
    reports::Measurement result(1.0 / columns);
    add_burning(simulation, result);
    return result;
}

/// What holds of every pack.
reports::Study study_of(const std::string& name) {
    reports::Study study(name);
    study.refines("columns", {120})
        .bound(nodes, 120, at_least(30), "or the next row would show nothing")
        .bound(burning_error, 120, at_most(1e-9),
               "the same formula from constants typed in twice: round-off");
    return study;
}

std::vector<reports::Study> studies() {
    reports::Study whole = study_of("pack-burning");
    whole.measure(burnt)
        .covers({term::moving_morphology, term::elastic_interface, term::stress_advection,
                 term::pyrolysis})
        .bound(jump, 120, at_most(0.05),
               "0.13 where cut cells take the arithmetic mean of the shear moduli, 0.024 here")
        .bound(peak, 120, at_most(1.0),
               "the arithmetic mean has 4.6 after 4 ms: AP's stress left in binder; 0.52 here")
        .bound(shear, 120, at_most(10.0),
               "2 mu times a strain of 1, doubled; 49 where a cell that softens gives up nothing");
    const auto rigid = [](const std::string& name, Front front) {
        reports::Study study = study_of(name);
        study.measure([front](int columns) { return burnt_rigid(columns, front); })
            .covers({term::moving_morphology, term::pyrolysis});
        return study;
    };
    return {whole, rigid("pack-burning, rigid", Front::faster_side),
            rigid("pack-burning, rigid, mean of materials", Front::mean_of_materials)};
}

const Registered here{
    {.name = "pack-burning",
     .figure = "-",
     .shows = "72 % pack, 10 ms: no cell keeps a stress its material cannot carry",
     .physics = {physics::pack},
     .cost = {.verify = 15.0},
     .studies = studies}};

}  // namespace

}  // namespace crawford
