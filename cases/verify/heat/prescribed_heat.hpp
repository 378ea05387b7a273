/// The heat step alone: temperature moves, everything else is prescribed.
#pragma once

#include <functional>
#include <vector>

#include "reference/manufactured_heat.hpp"
#include "reports/measurement.hpp"
#include "solver/heat/heat_sources.hpp"
#include "solver/mesh/lattice.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

/// What a heat step is given, and the temperature it should find. An empty function is zero; an
/// empty velocity is a rigid solid.
struct PrescribedHeat {
    using Field = std::function<double(double x, double y, double t)>;
    using Line = std::function<double(double x, double t)>;

    Scene scene = {};  ///< its time.end is where the comparison is made
    Field temperature = {};
    double start = 0.0;  ///< time at which the temperature is the given one [s]
    Line surface = {};
    Line surface_rate = {};
    std::function<Vector(double x, double y, double t)> velocity = {};
    /// DT/Dt at `start`, where the stress work is split; later the step's own is handed on.
    Field material_rate = {};
    HeatSources sources = {};
    /// Where in a step the motion is taken: 0, its start, as a burning solid must; 0.5, its middle,
    /// does not add an error of first order in time.
    double motion_at = 0.5;
};

/// A block of one material at rest under a level surface that takes up no heat: periodic, half as
/// many cells across as up, compared after 1 ms, in which heat goes as far as the fields change.
Scene heated_block(const Material& material, int cells, double clustering);
/// The same block for a truth, rigid, steady, and 300 K hotter at the surface than at the bottom.
reference::HeatedSolid heated_block(const reference::Material& material);

/// The scene driven to the manufactured temperature by its source and surface flux.
PrescribedHeat manufactured(const Scene& scene, const reference::HeatedSolid& solid);

/// The same below a surface that burns by pyrolysis under 100 cal/(s cm2): the flame's flux and
/// what pyrolysis absorbs come from the solver's burning law, the source of flux gives only the
/// rest.
PrescribedHeat burning(Scene scene, const reference::HeatedSolid& solid,
                       const reference::Material& material);

/// Temperature at every node at the end, with the size of the cells that each stands for.
struct FoundHeat {
    std::vector<double> temperature, exact, weight;
};

/// \throws NumericalFailure as HeatStep::advance
FoundHeat advance(const PrescribedHeat& heat, int steps);

/// The error of T, against a cell size h.
reports::Measurement error_of_temperature(const FoundHeat& found, double h);

}  // namespace crawford
