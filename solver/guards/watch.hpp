/// The worst that a run meets of the numbers by which it is judged.
#pragma once

#include <functional>
#include <map>

#include "solver/guards/guard.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

/// One number: the worst so far, and what it is judged by when it becomes worse.
class Worst {
public:
    using Judge = std::function<Guard(double)>;

    explicit Worst(Judge judge) : judge_(std::move(judge)) {}

    /// \returns the number, when it is for the first time beyond its limit.
    std::optional<Guard> meet(double value);
    Guard guard() const { return judge_(value_); }

private:
    Judge judge_;
    double value_ = 0.0;
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
    /// What is crossed in one step.
    struct Crossed {
        double columns = 0.0, rows = 0.0;  ///< by the solid
        double of_surface = 0.0;           ///< columns, by a slope of the surface
        double slope = 0.0;
    };

    Crossed crossed(const Simulation& simulation, const Summary& summary);
    double turning(double burn_rate);
    void watch(const Scene& scene, const Grid& grid);

    std::vector<double> rows_in_a_metre_;  ///< at each node row, by the lower cell beside it [1/m]
    double narrowest_;                     ///< column [m]
    SurfaceField surface_;                 ///< before the step
    std::vector<double> burn_rates_;       ///< of the last steps
    std::map<std::string, Worst, std::less<>> worst_;  ///< of what the scene can meet
};

}  // namespace crawford
