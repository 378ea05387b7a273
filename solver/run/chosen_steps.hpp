/// Steps as long as their error allows.
#pragma once

#include <optional>

#include "base/errors.hpp"
#include "solver/guards/crossed.hpp"
#include "solver/run/step_error.hpp"
#include "solver/run/steps.hpp"

namespace crawford {

/// A step is taken where it adds less than time.accuracy of error (step_error.hpp); else it is
/// tried again, shorter. The next one is as long as the error of this one lets it be. A step that
/// fails, or in which solid or slopes cross more than a cell, is tried again as well: where a number
/// is beyond its limit, by that much shorter. The next one is planned to cross no more than 0.85 of
/// a cell: what is explicit goes not much further.
///
/// Steps end at the times of snapshots and at time.end, and before these the way that is left is
/// shared out evenly. Checkpoints shorten none: a run does not depend on them.
class ChosenSteps : public Steps {
public:
    /// The grid must outlive it.
    ChosenSteps(const Scene& scene, const Grid& grid);

    void advance(Simulation& simulation) override;
    bool at_the_end(const State& state) const override { return state.time >= time_.end; }
    long last_step(const State& state) const override;

    std::optional<StepChoice> choice() const override {
        return StepChoice{next_, limit_, error_.memory(), count_};
    }
    void resume(const StepChoice& choice) override;

private:
    /// Where a step ends, and how long it is [s].
    struct Span {
        double end, length;
    };
    Span span_from(double now) const;
    double next_stop(double now) const;
    /// Takes it if it can be taken and is good enough.
    bool try_step(Simulation& simulation, const Span& span, int trials);
    void shorten(const NumericalFailure& failure, double tried);
    void accept(double length, double error, double crossed);
    double change_for(double error) const;

    Time time_;
    std::optional<double> snapshots_every_;
    StepError error_;
    Crossing crossing_;
    double next_;     ///< [s]
    double ceiling_;  ///< of all steps [s]
    double limit_;    ///< below which steps did not fail of late [s]
    StepCount count_;
};

}  // namespace crawford
