/// The worst that a run meets of the numbers by which it is judged.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "solver/guards/crossed.hpp"
#include "solver/guards/guard.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

/// One number: the worst so far, and what it is judged by when it becomes worse.
class Worst {
public:
    using Judge = std::function<Guard(double)>;
    enum class Is { largest, least };

    explicit Worst(Judge judge, Is worst = Is::largest)
        : judge_(std::move(judge)),
          worst_(worst),
          value_(worst == Is::least ? std::numeric_limits<double>::infinity() : 0.0) {}

    /// \returns the number, when it is for the first time beyond its limit.
    std::optional<Guard> meet(double value);
    Guard guard() const { return judge_(value_); }
    bool is_met() const { return std::isfinite(value_); }

private:
    Judge judge_;
    Is worst_;
    double value_;
    bool told_ = false;
};

class Watch {
public:
    /// For a run that goes on from where the simulation now stands.
    explicit Watch(const Simulation& simulation);

    /// After each step.
    /// \returns the numbers that are beyond their limit and were not before.
    /// \throws NumericalFailure if the coupling is beyond the limit of its scheme.
    Guards record(const Simulation& simulation, const Summary& summary);

    /// The worst so far, by name.
    Guards met() const;

private:
    double turning(double burn_rate);
    void watch(const Scene& scene, const Grid& grid);
    void watch_heat(const Scene& scene, const Grid& grid);
    double slowest_move(const State& state, double burn_rate) const;

    Crossing crossing_;
    SurfaceField surface_;                             ///< before the step
    std::vector<double> burn_rates_;                   ///< of the last steps
    double diffusivity_;                               ///< largest of the materials [m^2/s]
    std::map<std::string, Worst, std::less<>> worst_;  ///< of what the scene can meet
};

}  // namespace crawford
