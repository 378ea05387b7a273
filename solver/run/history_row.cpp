#include "solver/run/history_row.hpp"

#include "solver/run/peak.hpp"

namespace crawford {

HistoryRow history_row(const Simulation& simulation, const Summary& summary,
                       const Widening& widening) {
    const State& state = simulation.state();
    HistoryRow row{.time = state.time,
                   .mean_burn_rate = summary.mean_burn_rate,
                   .largest_temperature = summary.largest_temperature,
                   .largest_strain = summary.largest_strain,
                   .residual = summary.residual,
                   .solver_iterations = double(summary.solver_iterations),
                   .regression_rate = summary.regression_rate,
                   .least_temperature = summary.least_temperature,
                   .largest_slope = largest_slope(simulation.grid(), state.surface),
                   .step = state.length};
    if (state.stress.pressure.empty()) return row;
    const NodeVectors position = widening.places(positions(simulation.grid(), state.surface));
    const CellField material = widening.cells(simulation.material_fraction());
    const auto peak_of = [&](const CellField& field) {
        return peak(position, material, widening.cells(field), peak_radius);
    };
    const Peak pressure = peak_of(state.stress.pressure);
    row.largest_pressure = pressure.value;
    row.pressure_about_peak = pressure.mean;
    if (!state.reference_shift.empty())
        row.strain_about_peak = peak_of(simulation.strain_norm()).mean;
    return row;
}

}  // namespace crawford
