/// # Response: how does the burn rate answer a flame that swings?
///
/// A slab that burns steadily is heated by Q (1 + a cos 2 pi f t). Its surface temperature and with
/// it its burn rate then swing too: (r'/r)/a, a complex number for each frequency, is what
/// experiments with a modulated laser measure and what the stability of combustion is computed
/// from. Without mechanics it has a closed form (reference/flux_response.hpp), with it a complex
/// boundary-value problem is shot (reference/flux_response_shooting.hpp); where nothing expands the
/// two agree to 1e-11. Both are linear in a: at a = 1e-3 the solver differs by 1e-6.
///
/// The burn starts in the exact swing, so that no thermal layer has to relax, which takes 4 D/r^2,
/// some 40 ms, far longer than a fast period. Two periods are burnt and the second is read. From
/// 10 Hz, nearly quasi-steady, to 5 kHz, where the wave of heat is 3 um deep: amplitude within 1 %
/// and phase within one degree at steps of a hundredth of a period, 40 us at most, with bdf2. On
/// the coarser grids the step grows with the cell.
///
/// A slab of finite depth answers like one: the truths have the same bottom as the scene.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "cases/registry.hpp"
#include "cases/scenes/slab.hpp"
#include "cases/terms.hpp"
#include "cases/units.hpp"
#include "cases/verify/burning/exact_start.hpp"
#include "cases/verify/burning/series.hpp"
#include "reference/flux_response.hpp"
#include "reference/flux_response_shooting.hpp"
#include "solver/run/loop.hpp"

namespace crawford {

namespace {

using namespace units;
using Complex = std::complex<double>;
using reports::between;
using reports::expect;
using reports::Norm;

constexpr double swing_of_flux = 1e-3;
constexpr int finest = 192;  // rows: the first cell is 0.63 um high
constexpr double frequencies[] = {10.0, 50.0, 150.0, 500.0, 1500.0, 5000.0};  // [Hz]

struct Burning {
    std::string material;
    double flux;  ///< [W/m^2]
    bool expands = false;
    bool constant_volume = false;
};

/// Steps a period: of a hundredth, 40 us at most, on the finest grid.
int steps_of(double frequency, int rows) {
    const double fewest = std::max(100.0, 1.0 / (frequency * 40.0 * us));
    const int coarsest = int(std::ceil(fewest / 4.0));
    return coarsest * 4 * rows / finest;
}

Slab slab_of(const Burning& b, int rows) {
    Slab result = slab(b.material, {.cells = rows, .clustering = 2.0, .depth = 480.0 * um})
                      .burning_by_law()
                      .heated(b.flux)
                      .pressed(2.0 * MPa);
    return b.expands ? result : result.rigid();
}

reference::SlabConditions conditions_of(const Burning& b) {
    auto conditions = slab_of(b, 1).conditions(b.expands ? reference::SlabModel::eulerian
                                                         : reference::SlabModel::thermal);
    if (b.constant_volume) conditions.heat_capacity = reference::HeatCapacity::constant_volume;
    return conditions;
}

Scene scene_of(const Burning& b, double frequency, int rows) {
    Scene scene = slab_of(b, rows).scene();
    scene.physics.reference_map = false;
    scene.surface.modulation = {.amplitude = swing_of_flux, .frequency = frequency};
    scene.time.scheme = Stepping::bdf2;
    scene.time.step = 1.0 / (frequency * steps_of(frequency, rows));
    if (b.constant_volume) scene.numerics.heat_capacity = HeatCapacity::constant_volume;
    return scene;
}

/// The swing of the slab at the nodes of a grid, and what it swings about.
struct Swing {
    std::vector<reference::SlabState> steady;
    std::vector<reference::Fluctuation> swinging;
    Complex burn_rate;
    double mean_rate;
};

Swing swing_at(const Burning& b, double frequency, const std::vector<double>& y) {
    const auto conditions = conditions_of(b);
    Swing result;
    if (b.expands) {
        const reference::FluxResponseShooting exact(conditions, frequency);
        result = {exact.slab().states(y), exact.fluctuations(y), exact.burn_rate(),
                  exact.slab().burn_rate()};
    } else {
        const reference::FluxResponse exact(conditions, frequency);
        result = {exact.slab().states(y), {}, exact.burn_rate(), exact.slab().burn_rate()};
        for (const double height : y) result.swinging.push_back({exact.temperature(height), 0, 0});
    }
    return result;
}

/// Velocity, stress and DT/Dt of the swinging slab. Only sigma_22 matters to the rest, and it is
/// -p_c; the lateral stress is the steady one.
void set_mechanics(State& state, const Grid& grid, const Swing& s, Complex phasor, double w) {
    const auto node_velocity = [&](int j) {
        return s.steady[size_t(j)].velocity + (s.swinging[size_t(j)].velocity * phasor).real();
    };
    const auto material_rate = [&](int j) {
        const auto& [steady, swinging] = std::tie(s.steady[size_t(j)], s.swinging[size_t(j)]);
        const double carried = s.mean_rate + steady.velocity;
        const Complex more =
            Complex(0.0, w) * swinging.temperature + carried * swinging.temperature_gradient +
            (s.mean_rate * s.burn_rate + swinging.velocity) * steady.temperature_gradient;
        return carried * steady.temperature_gradient + (more * phasor).real();
    };
    for (int i = 0; i < grid.node_columns(); ++i)
        for (int j = 0; j <= grid.rows(); ++j) state.velocity(i, j) = {0.0, node_velocity(j)};
    for (int i = 0; i < grid.cell_columns(); ++i)
        for (int j = 0; j < grid.rows(); ++j) {
            const reference::SlabState& below = s.steady[size_t(j)];
            const reference::SlabState& above = s.steady[size_t(j + 1)];
            const double pressure = 0.5 * (below.pressure + above.pressure);
            const double lateral = 0.5 * (below.stress_11 + above.stress_11) + pressure;
            state.stress.pressure(i, j) = pressure;
            for (auto& deviator : state.stress.deviator)
                deviator(i, j) = {.s11 = lateral, .s22 = -2.0 * lateral, .s12 = 0.0};
            state.temperature_rate(i, j) = 0.5 * (material_rate(j) + material_rate(j + 1));
        }
}

struct Response {
    Complex found, exact;
};

Response response(const Burning& b, double frequency, int rows) {
    Simulation simulation(scene_of(b, frequency, rows));
    const Grid& grid = simulation.grid();
    std::vector<double> y;
    for (int j = 0; j <= rows; ++j) y.push_back(grid.eta(j));
    const Swing exact = swing_at(b, frequency, y);
    const double w = 2.0 * std::numbers::pi * frequency;
    const auto phasor = [=](double t) { return swing_of_flux * std::exp(Complex(0.0, w * t)); };

    // T is asked for column by column from the bottom up, at the heights above.
    const auto row_of = [&](double eta) {
        return size_t(std::ranges::lower_bound(y, eta) - y.begin());
    };
    ExactFront start;
    start.surface = [&](double, double t) { return -exact.mean_rate * t; };
    start.temperature = [&](double, double eta, double t) {
        const size_t j = row_of(eta);
        return exact.steady[j].temperature + (exact.swinging[j].temperature * phasor(t)).real();
    };
    if (b.expands)
        start.mechanics = [&](State& state, const Grid& g, double t) {
            set_mechanics(state, g, exact, phasor(t), w);
        };
    start_exactly(simulation, start);

    const int period = steps_of(frequency, rows);
    run_steps(simulation, period);
    std::vector<double> rate;
    const double read_from = simulation.state().time + simulation.scene().time.step;
    run_steps(simulation, period,
              {[&](Simulation& s, double) { rate.push_back(s.burn_rate().front()); }});
    const Complex swung = swing(rate, read_from, simulation.scene().time.step, w);
    return {swung / (exact.mean_rate * swing_of_flux), exact.burn_rate};
}

std::string at(const char* what, double frequency) {
    return fmt::format("{} at {} Hz", what, frequency);
}

constexpr auto complex_response = "response";
constexpr auto amplitude = "amplitude/exact - 1";
constexpr auto phase = "phase - exact [deg]";

reports::Measurement measure(const Burning& b, int rows) {
    reports::Measurement result(1.0 / rows);
    for (const double frequency : frequencies) {
        const auto [found, exact] = response(b, frequency, rows);
        result
            .error(at(complex_response, frequency), Norm::magnitude, std::abs(found - exact),
                   std::abs(exact))
            .value(at(amplitude, frequency), std::abs(found / exact) - 1.0)
            .value(at(phase, frequency), std::arg(found / exact) * 180.0 / std::numbers::pi);
    }
    return result;
}

reports::Study study(const std::string& name, const Burning& b) {
    using namespace term;
    std::vector<std::string> covered{heat_storage,  heat_convection, heat_conduction, gas_flux,
                                     reaction_flux, pyrolysis,       time_step,       clustering};
    if (b.expands) covered.insert(covered.end(), {stress_work, thermal_stress, equilibrium});
    reports::Study study("response, " + name);
    study.refines("rows", {finest / 4, finest / 2, finest})
        .measure([b](int rows) { return measure(b, rows); })
        .covers(covered);
    for (const double frequency : frequencies)
        study
            .gate(at(complex_response, frequency), Norm::magnitude, expect(2.0).within(0.3),
                  "centred differences and bdf2, the step with the cell")
            .bound(at(amplitude, frequency), finest, between(-0.01, 0.01),
                   "1 % is below what experiments tell apart")
            .bound(at(phase, frequency), finest, between(-1.0, 1.0),
                   "likewise; a step is 3.6 degrees of a period at most");
    return study;
}

std::vector<reports::Study> studies() {
    const double ap = 200.0 * cal / (s * cm2);
    const double binder = 160.0 * cal / (s * cm2);
    return {
        study("rigid AP", {"AP", ap}), study("rigid binder", {"binder", binder}),
        study("AP, c_p", {.material = "AP", .flux = ap, .expands = true}),
        study("binder, c_p", {.material = "binder", .flux = binder, .expands = true}),
        study("binder, c_v",
              {.material = "binder", .flux = binder, .expands = true, .constant_volume = true})};
}

const Registered here{{.name = "response",
                       .figure = "-",
                       .shows = "burn rate of a slab under a flame that swings",
                       .physics = {physics::slab},
                       .cost = {.verify = 15.0},
                       .studies = studies}};

}  // namespace

}  // namespace crawford
