#include "solver/step/state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/element/element.hpp"
#include "solver/step/state_fields.hpp"

namespace crawford {

namespace {

void allocate(SurfaceField& field, Place, const Grid& grid, size_t) {
    field.assign(size_t(grid.node_columns()), 0.0);
}

template <class Value>
void allocate(Lattice<Value>& field, Place place, const Grid& grid, size_t) {
    field = place == Place::node ? Lattice<Value>(grid.node_columns(), grid.rows() + 1)
                                 : Lattice<Value>(grid.cell_columns(), grid.rows());
}

template <class Value>
void allocate(std::vector<Lattice<Value>>& field, Place place, const Grid& grid, size_t points) {
    field.resize(points);
    for (Lattice<Value>& point : field) allocate(point, place, grid, points);
}

template <class Value>
void combine(double a, Value& x, double b, const Value& y) {
    x = a * x + b * y;
}
template <class Value>
void combine(double a, Lattice<Value>& x, double b, const Lattice<Value>& y) {
    for (size_t k = 0; k < x.values().size(); ++k) combine(a, x.values()[k], b, y.values()[k]);
}
template <class Value>
void combine(double a, std::vector<Value>& x, double b, const std::vector<Value>& y) {
    for (size_t k = 0; k < x.size(); ++k) combine(a, x[k], b, y[k]);
}

bool alike(double, double) {
    return true;
}
template <class Value>
bool alike(const Lattice<Value>& a, const Lattice<Value>& b) {
    return a.columns() == b.columns() && a.rows() == b.rows();
}
template <class Value>
bool alike(const std::vector<Value>& a, const std::vector<Value>& b) {
    return std::ranges::equal(a, b, [](const Value& x, const Value& y) { return alike(x, y); });
}

SurfaceField surface_of(const Ripple& ripple, const Grid& grid, double width) {
    SurfaceField surface(size_t(grid.node_columns()));
    const double wave_number = 2.0 * std::numbers::pi * ripple.waves / width;
    for (int i = 0; i < grid.node_columns(); ++i)
        surface[size_t(i)] = ripple.amplitude * std::cos(wave_number * grid.x(i));
    return surface;
}

}  // namespace

State initial_state(const Scene& scene, const Grid& grid) {
    const size_t points = stress_points(scene.numerics.element).size();
    State state;
    for_each_state_field([&](const auto& field) {
        if (field.wanted(scene.physics)) allocate(field.of(state), field.place, grid, points);
    });
    std::ranges::fill(state.temperature.values(), scene.bottom.temperature);
    if (scene.surface.ripple)
        state.surface = surface_of(*scene.surface.ripple, grid, scene.domain.width);
    return state;
}

bool same_shape(const State& a, const State& b) {
    bool same = true;
    for_each_state_field(
        [&](const auto& field) { same = same && alike(field.of(a), field.of(b)); });
    return same;
}

State combination(double a, const State& x, double b, const State& y) {
    State sum = x;
    for_each_state_field([&](const auto& field) { combine(a, field.of(sum), b, field.of(y)); });
    return sum;
}

}  // namespace crawford
