#include "solver/heat/heat_step.hpp"

#include <cmath>

#include "base/errors.hpp"
#include "solver/heat/line_relaxation.hpp"
#include "solver/mesh/node_lengths.hpp"

namespace crawford {

namespace {

constexpr std::array<Local, 4> vertices{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}};

void check(const NodeField& temperature, const char* advice) {
    for (int i = 0; i < temperature.columns(); ++i)
        for (int j = 0; j < temperature.rows(); ++j)
            if (!(temperature(i, j) > 0.0 && std::isfinite(temperature(i, j))))
                throw NumericalFailure({.kind = FailureFields::Kind::beyond_limit,
                                        .module = "heat",
                                        .quantity = "temperature",
                                        .value = temperature(i, j),
                                        .unit = "K",
                                        .limit = FailureLimit{.value = 0.0, .is_least = true},
                                        .place = FailurePlace{"node", i, j},
                                        .advice = advice});
}

}  // namespace

double stiffest_rate(const Grid& grid, double diffusivity) {
    double curvature = 0.0;
    for (int j = 0; j < grid.rows(); ++j)
        curvature = std::max(curvature, 1.0 / (grid.height(j) * grid.height(j)));
    double along_rows = 0.0;
    for (int i = 0; i < grid.cell_columns(); ++i)
        along_rows = std::max(along_rows, 1.0 / (grid.dx(i) * grid.dx(i)));
    if (grid.node_columns() > 1) curvature += along_rows;
    return 4.0 * curvature * diffusivity;
}

/// (1 - (1 - theta) z)/(1 + theta z) >= -0.9, z = dt times the stiffest rate.
double least_implicit(double dt, double stiffest_rate) {
    constexpr double left = 0.9;
    return 1.0 / (1.0 + left) - 1.0 / (dt * stiffest_rate);
}

HeatStep::HeatStep(const Scene& scene, const Grid& grid, const MaterialMap& materials,
                   const BurningLaw& law, const HeatSources& sources)
    : grid_(grid),
      materials_(materials),
      law_(law),
      source_(sources.heat),
      flux_source_(sources.heat_flux),
      numerics_(scene.numerics),
      scheme_(scene.time.scheme),
      deforms_(scene.physics.mechanics),
      stiffest_rate_(stiffest_rate(grid, largest_diffusivity(scene.morphology.materials))),
      transport_(grid),
      mass_(grid.node_columns(), grid.rows() + 1),
      load_(grid.node_columns(), grid.rows() + 1) {}

int HeatStep::advance(NodeField& temperature, const NodeField& lagged, const HeatMotion& motion,
                      const TimeStep& step) {
    assemble(lagged, motion);
    add_surface_flux(lagged, motion.surface);
    if (source_) add_source(motion.surface, step.heat_time());
    if (flux_source_) add_flux_source(motion.surface, step.heat_time());

    // (M/dt + theta L) T' = (M/dt - (1 - theta) L) T + load   (paper eq. 34, theta = 1/2)
    const double theta = step.implicit_heat;
    NodeField& rhs = load_;
    for (int i = 0; i < temperature.columns(); ++i)
        for (int j = 1; j < temperature.rows(); ++j)
            rhs(i, j) += mass_(i, j) / step.span * temperature(i, j) -
                         (1.0 - theta) * transport_.apply(temperature, i, j);
    for (int i = 0; i < temperature.columns(); ++i)
        for (int j = 0; j < temperature.rows(); ++j) {
            for (auto& column : transport_.row(i, j))
                for (double& c : column) c *= theta;
            transport_.row(i, j)[1][1] += mass_(i, j) / step.span;
        }
    const double hottest = *std::ranges::max_element(temperature.values());
    const Relaxation done =
        relax_columns(transport_, rhs, temperature, numerics_.heat_tolerance * hottest);
    contraction_ = done.contraction;
    check(temperature, deforms_ && numerics_.coupling == Coupling::lagged
                           ? "reduce time.step, or take numerics.coupling = \"adiabatic\""
                           : "reduce time.step");
    return done.sweeps;
}

void HeatStep::assemble(const NodeField& temperature, const HeatMotion& motion) {
    coupling_ = 0.0;
    transport_.clear();
    std::ranges::fill(mass_.values(), 0.0);
    std::ranges::fill(load_.values(), 0.0);
    for (int i = 0; i < grid_.cell_columns(); ++i)
        for (int j = 0; j < grid_.rows(); ++j) add_cell(i, j, temperature, motion);
}

/// rho c, with c = c_p or, where the coupling is to supply c_p - c_v, c_v = c_p - beta^2 T/(rho K).
double HeatStep::capacity(int i, int j, double temperature) const {
    const double at_constant_pressure = materials_.heat_capacity(i, j);
    if (numerics_.heat_capacity == HeatCapacity::constant_pressure) return at_constant_pressure;
    const double beta = materials_.thermal_stress(i, j, numerics_.stress_work);
    return at_constant_pressure - beta * beta * temperature / materials_.bulk_modulus(i, j);
}

/// beta^2 T/K: the heat that expansion at constant pressure absorbs per degree, zero where the
/// coupling lags.
double HeatStep::adiabatic_capacity(int i, int j, double temperature) const {
    if (numerics_.coupling == Coupling::lagged) return 0.0;
    const double beta = materials_.thermal_stress(i, j, numerics_.stress_work);
    return beta * beta * temperature / materials_.bulk_modulus(i, j);
}

/// Beyond its limit the stress work alternates from step to step and grows, however small the step.
void HeatStep::check_coupling(int i, int j, double heat_capacity, double temperature) {
    const auto fail = [&](const char* quantity, double value, FailureLimit limit,
                          std::string advice) {
        limit.condition = coupling_condition(numerics_.coupling, scheme_);
        throw NumericalFailure({.kind = FailureFields::Kind::beyond_limit,
                                .module = "heat",
                                .quantity = quantity,
                                .value = value,
                                .limit = std::move(limit),
                                .place = FailurePlace{"cell", i, j},
                                .advice = std::move(advice)});
    };
    if (numerics_.coupling == Coupling::lagged && heat_capacity <= 0.0)
        fail("heat capacity rho c_v [J/(m3 K)]", heat_capacity, {.value = 0.0, .is_least = true},
             "take numerics.coupling = \"adiabatic\"");
    const CoupledSolid solid{
        .heat_capacity = heat_capacity,
        .bulk_modulus = materials_.bulk_modulus(i, j),
        .shear_modulus = materials_.shear_modulus(i, j),
        .stress_of_heat = materials_.thermal_stress(i, j, numerics_.thermal_stress),
        .heat_of_stretch = materials_.thermal_stress(i, j, numerics_.stress_work)};
    const double coupling = coupling_number(solid, numerics_.coupling, temperature);
    const double limit = coupling_of_a_lost_step(scheme_);
    if (coupling >= limit)
        fail("coupling number g", coupling, {.value = limit},
             coupling_advice(solid, numerics_.coupling, scheme_, temperature));
    coupling_ = std::max(coupling_, coupling);
}

void HeatStep::add_cell(int i, int j, const NodeField& temperature, const HeatMotion& motion) {
    const Cell cell(grid_, motion.surface, i, j);
    const auto nodes = corners(grid_, i, j);
    const double share = 0.25 * cell.area();
    const Eigen::Matrix2d kappa =
        materials_.thermal_conductivity(i, j) * Eigen::Matrix2d::Identity() +
        materials_.further_conductivity(i, j);
    const double mean_temperature = interpolate(gather(temperature, nodes), cell_centre);

    double heat_capacity = capacity(i, j, mean_temperature);
    if (deforms_) {
        check_coupling(i, j, heat_capacity, mean_temperature);
        const double split = adiabatic_capacity(i, j, mean_temperature);
        add_stress_work(i, j, nodes, share, split, temperature, motion);
        heat_capacity += split;
    }

    Eigen::Matrix4d transport = Eigen::Matrix4d::Zero();
    for (int vertex = 0; vertex < 4; ++vertex) {
        const auto hats = hat_gradients(cell, vertices[size_t(vertex)]);
        const Vector carried = heat_capacity * relative_velocity(motion, nodes[size_t(vertex)]);
        for (int q = 0; q < 4; ++q) {
            transport(vertex, q) += share * carried.dot(hats[size_t(q)]);
            const Vector flux = share * kappa * hats[size_t(q)];
            for (int p = 0; p < 4; ++p) transport(p, q) += hats[size_t(p)].dot(flux);
        }
        const Node& node = nodes[size_t(vertex)];
        mass_(node.i, node.j) += share * heat_capacity;
    }
    for (int p = 0; p < 4; ++p)
        for (int q = 0; q < 4; ++q) transport_.add(nodes, p, q, transport(p, q));
}

/// -beta T div v of the last step. Split adiabatically, the part that answers DT/Dt at once, -split
/// DT/Dt, has moved to the left side and only the remainder lags; `split` is its largest value, at
/// constant pressure, so that the remainder never changes sign from step to step.
void HeatStep::add_stress_work(int i, int j, const std::array<Node, 4>& nodes, double share,
                               double split, const NodeField& temperature,
                               const HeatMotion& motion) {
    const Cell cell(grid_, motion.surface, i, j);
    const double beta = materials_.thermal_stress(i, j, numerics_.stress_work);
    const double divergence = gradient(cell, gather(motion.velocity, nodes), cell_centre).trace();
    const double lagged =
        motion.temperature_rate.empty() ? 0.0 : split * motion.temperature_rate(i, j);
    for (const Node& node : nodes)
        load_(node.i, node.j) += share * (lagged - beta * temperature(node.i, node.j) * divergence);
}

/// The flux that pyrolysis absorbs grows steeply with temperature: taken at the old one (as paper
/// sec. 2) it overshoots at steps beyond some 0.1 ms and burns on at a wrong rate, so its slope
/// goes to the left side (as a wall that cools).
void HeatStep::add_surface_flux(const NodeField& temperature, const SurfaceField& surface) {
    const int top = grid_.rows();
    for (int i = 0; i < grid_.cell_columns(); ++i) {
        const double length = grid_.dx(i) * std::hypot(1.0, grid_.slope(surface, i));
        const auto nodes = corners(grid_, i, top - 1);
        for (const PieceShare& piece : shares_of(materials_.surface_pieces()[size_t(i)])) {
            const std::array<double, 2> at{1.0 - piece.right, piece.right};
            const double now =
                at[0] * temperature(nodes[2].i, top) + at[1] * temperature(nodes[3].i, top);
            const LinearFlux flux = law_.heat_flux(materials_, piece.fraction, now);
            for (const size_t node : {0, 1}) {
                const double share = length * piece.of_node[node];
                load_(nodes[2 + node].i, top) += share * (flux.value - flux.slope * now);
                for (const size_t other : {0, 1})
                    transport_.add(nodes, int(2 + node), int(2 + other),
                                   -share * flux.slope * at[other]);
            }
        }
    }
}

void HeatStep::add_source(const SurfaceField& surface, double time) {
    const NodeField areas = node_areas(grid_);
    for (int i = 0; i < areas.columns(); ++i)
        for (int j = 0; j < areas.rows(); ++j)
            load_(i, j) +=
                areas(i, j) * source_(grid_.x(i), surface[size_t(i)] + grid_.eta(j), time);
}

void HeatStep::add_flux_source(const SurfaceField& surface, double time) {
    const SurfaceField lengths = node_lengths(grid_, surface);
    for (int i = 0; i < grid_.node_columns(); ++i)
        load_(i, grid_.rows()) +=
            lengths[size_t(i)] * flux_source_(grid_.x(i), surface[size_t(i)], time);
}

void material_rate(const Grid& grid, const NodeField& before, const NodeField& after,
                   const SolidMotion& motion, double dt, CellField& rate) {
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j) {
            const Cell cell(grid, motion.surface, i, j);
            const auto nodes = corners(grid, i, j);
            const auto hot = gather(after, nodes);
            const auto cold = gather(before, nodes);
            Vector carried = Vector::Zero();
            for (const Node& node : nodes) carried += 0.25 * relative_velocity(motion, node);
            rate(i, j) = (interpolate(hot, cell_centre) - interpolate(cold, cell_centre)) / dt +
                         carried.dot(gradient(cell, hot, cell_centre));
        }
}

}  // namespace crawford
