/// The error that one step adds, from how the slopes of what is watched change: no solve is spent
/// on it.
#pragma once

#include <utility>
#include <vector>

#include "solver/files/step_choice.hpp"
#include "solver/scene/scene.hpp"
#include "solver/step/state.hpp"

namespace crawford {

class StepError {
public:
    StepError(const Scene& scene, const Grid& grid);

    /// Of the step from `before` to `after`, relative: the largest of
    ///  - that of the surface's temperatures, to the hottest,
    ///  - that of the burn rate, which follows them as Ea/(R T) dT/T, to the largest rate so far or,
    ///    while the layer still forms, to the speed sqrt(D/t) at which it does, and
    ///  - that of the mean height, which piles up over the time D/r^2 in which the rate settles, to
    ///    what burns away until time.end.
    /// Of the temperatures the median is taken: a node whose material changes has a kink in time
    /// there, which no step resolves and which does not last. Zero while fewer steps are behind than
    /// it takes to tell, and where nothing is heated.
    ///
    /// A step of forward Euler misses y'' dt^2/2. One that looks back two states misses
    /// y''' dt (dt + dt') span/6 by the parabola's slope, and three times that by what is explicit,
    /// which is extrapolated along a line.
    double of(const State& before, const State& after) const;

    /// Goes on from `after`.
    void accept(const State& before, const State& after);

    /// Of the error, in powers of the step: 2 or 3.
    int order() const { return order_; }

    const StepMemory& memory() const { return memory_; }
    void resume(StepMemory memory) { memory_ = std::move(memory); }

private:
    static std::vector<double> slopes(const State& before, const State& after);
    std::vector<double> curvatures(const std::vector<double>& slopes, double length) const;
    std::vector<double> derivatives(const std::vector<double>& slopes, double length) const;
    double span_of(double length) const;
    double missed(double length) const;
    double mean_rate(const State& before, const State& after) const;

    const Grid& grid_;
    double end_;  ///< [s]
    int order_;
    double diffusivity_;  ///< largest of the materials [m^2/s]
    double activation_;   ///< largest Ea/R of the materials [K]
    StepMemory memory_;
};

}  // namespace crawford
