/// Heights of a front that burns at a given rate: the problems of cases/verify/burning/surface.cpp.
#include <fmt/format.h>

#include <cmath>

#include "cases/explore/coverage/known_problem.hpp"
#include "cases/units.hpp"
#include "cases/verify/burning/burn_surface.hpp"
#include "reference/regressing_front.hpp"
#include "solver/burning/surface_motion.hpp"

namespace crawford {

namespace {

using namespace units;

constexpr double width = 240.0 * um;
constexpr double burn_rate = 4.5e-3 * m / s;

/// What begins as `phi` at t = 0, at four nodes after `end`.
template <class Exact>
std::vector<KnownValue> burnt(int cells, double end, const Exact& phi) {
    const Grid grid({.width = width, .depth = width, .nx = cells, .ny = 2});
    SurfaceField surface;
    for (int i = 0; i < cells; ++i) surface.push_back(phi(grid.x(i), 0.0));
    const SurfaceField rates(surface.size(), burn_rate);
    const int steps = int(std::ceil(2.5 * end * burn_rate / grid.dx()));
    surface = burn_surface(surface, end, steps, [&](const SurfaceField& front, double) {
        return surface_rate(grid, front, rates, {});
    });
    std::vector<KnownValue> values;
    for (const double across : {0.0, 0.25, 0.5, 0.75}) {
        const int i = node_at(grid, {across, 1.0}).i;
        values.push_back(
            {fmt::format("phi at {:g} [m]", across), surface[size_t(i)], phi(grid.x(i), end)});
    }
    return values;
}

/// At `part` of its time to the kink.
KnownProblem wave(Fidelity fidelity, const std::string& name, double order, double part) {
    return {"front", "front, " + name, order, grids_of(fidelity, 4), [=](int cells) {
                const reference::RegressingWave exact(20.0 * um, width, burn_rate);
                return burnt(cells, part * exact.kink_time(), [&](double x, double t) {
                    return exact.envelope(x - width / 3.0, t);
                });
            }};
}

}  // namespace

std::vector<KnownProblem> front_problems(Fidelity fidelity) {
    return {wave(fidelity, "before its kink", 3.0, 0.5),
            wave(fidelity, "near its kink", 3.0, 0.9),
            wave(fidelity, "after its kink", 2.0, 1.5),
            {"front", "front, zigzag", 1.0, grids_of(fidelity, 4), [](int cells) {
                 const reference::RegressingZigzag exact(0.9, 0.5, width, burn_rate);
                 return burnt(cells, 0.25 * width / burn_rate,
                              [&](double x, double t) { return exact.height(x, t); });
             }}};
}

}  // namespace crawford
