/// The worst that a run meets of the numbers by which it is judged.
#pragma once

#include <deque>

#include "solver/guards/guard.hpp"
#include "solver/step/simulation.hpp"

namespace crawford {

class Watch {
public:
    /// For a run that goes on from where the simulation now stands.
    explicit Watch(const Simulation& simulation);

    /// After each step.
    /// \returns the numbers that are beyond their limit and were not before.
    /// \throws NumericalFailure if the coupling is beyond the limit of its scheme.
    Guards record(const Simulation& simulation, const Summary& summary);

    /// The worst so far, by name.
    const Guards& met() const { return met_; }

private:
    struct Crossed {
        double columns = 0.0, rows = 0.0;  ///< by the solid, in one step
        double of_surface = 0.0;           ///< columns, by a slope of the surface
        double slope = 0.0;
    };

    Crossed crossed(const Simulation& simulation, const Summary& summary);
    double alternation(double burn_rate);
    Guards take(const Guards& now);
    void check_coupling(const Simulation& simulation, double coupling) const;

    std::vector<double> rate_of_rows_;  ///< of node row j: 1/height of the lower cell beside it
    double narrowest_;                  ///< column [m]
    SurfaceField surface_;              ///< before the step
    std::deque<double> burn_rates_;     ///< of the last steps
    Guards met_;
};

}  // namespace crawford
