#include "cases/verify/coupled/balance.hpp"

#include <algorithm>
#include <cmath>

#include "reference/material.hpp"
#include "solver/mesh/cell.hpp"

namespace crawford {

namespace {

class Window {
public:
    explicit Window(const Simulation& simulation) : simulation_(simulation) {}

    Instant look() const {
        const Grid& grid = simulation_.grid();
        Instant now;
        for (int i = 0; i < grid.cell_columns(); ++i) {
            const reference::Material m = material(i);
            for (const int node : {i, grid.right_node(i)}) add_surface(now, i, node, m);
            for (int j = 0; j < grid.rows(); ++j) add_cell(now, i, j, m);
        }
        return now;
    }

private:
    void add_surface(Instant& now, int i, int node, const reference::Material& m) const {
        const Grid& grid = simulation_.grid();
        const SurfaceField& surface = simulation_.state().surface;
        const double half_length = 0.5 * grid.dx() * std::hypot(1.0, grid.slope(surface, i));
        const double hot = simulation_.state().temperature(node, grid.rows());
        const double r_b = m.pyrolysis_prefactor * std::exp(-m.activation_temperature / hot);
        now.in += half_length * (flux(i) + m.heat_of_reaction * m.density * r_b);
        now.burnt += half_length * m.density * simulation_.burn_rate()[size_t(node)];
        now.height.push_back(surface[size_t(node)]);
        now.mass.push_back(0.5 * grid.dx() * m.density);
        now.heat.push_back(now.mass.back() * m.specific_heat * (hot - cold()));
    }

    void add_cell(Instant& now, int i, int j, const reference::Material& m) const {
        const State& state = simulation_.state();
        const Cell cell(simulation_.grid(), state.surface, i, j);
        const auto nodes = corners(simulation_.grid(), i, j);
        const auto v = gather(state.velocity, nodes);
        const auto t = gather(state.temperature, nodes);
        const double mean = interpolate(t, cell_centre);
        const double heat_capacity = cell.area() * m.density * m.specific_heat;
        const double beta = 3.0 * m.thermal_expansion * m.bulk_modulus;
        now.stored += heat_capacity * (mean - cold());
        now.carried +=
            heat_capacity * interpolate(v, cell_centre).dot(gradient(cell, t, cell_centre));
        now.work += cell.area() * beta * mean * gradient(cell, v, cell_centre).trace();
    }

    bool of_first_material(int i) const { return simulation_.material_fraction()(i, 0) > 0.5; }
    double cold() const { return simulation_.scene().bottom.temperature; }
    double flux(int i) const {
        const auto& flux = simulation_.scene().surface.heat_flux;
        return of_first_material(i) ? flux.front() : flux.back();
    }
    reference::Material material(int i) const {
        const auto& materials = simulation_.scene().morphology.materials;
        const auto& found = of_first_material(i) ? materials.front() : materials.back();
        return found.name == "AP" ? reference::ap() : reference::binder();
    }

    const Simulation& simulation_;
};

}  // namespace

Instant look(const Simulation& simulation) {
    return Window(simulation).look();
}

void Account::add(const Instant& a, const Instant& b, double dt) {
    const auto over_step = [&](auto flow) { return 0.5 * dt * (a.*flow + b.*flow); };
    const double entered = over_step(&Instant::in);
    const double gone = over_step(&Instant::burnt);
    in += entered;
    burnt += gone;
    missing +=
        entered - over_step(&Instant::carried) - over_step(&Instant::work) - (b.stored - a.stored);
    unswept += gone;
    for (size_t k = 0; k < a.height.size(); ++k) {
        const double regressed = a.height[k] - b.height[k];
        missing -= regressed * 0.5 * (a.heat[k] + b.heat[k]);
        unswept -= regressed * a.mass[k];
    }
}

double force_lost(const Simulation& simulation) {
    const Grid& grid = simulation.grid();
    const State& state = simulation.state();
    const double load = simulation.scene().surface.pressure * grid.width();
    double largest = 0.0;
    for (int j = 0; j < grid.rows(); ++j) {
        double carried = 0.0;
        for (int i = 0; i < grid.cell_columns(); ++i) {
            const PlaneStress s = state.stress.mean(i, j);
            carried -= grid.dx() * (s.s22 - grid.slope(state.surface, i) * s.s12);
        }
        largest = std::max(largest, std::abs(carried / load - 1.0));
    }
    return largest;
}
}  // namespace crawford
