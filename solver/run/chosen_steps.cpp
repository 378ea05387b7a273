#include "solver/run/chosen_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace crawford {

namespace {

/// Of what the error allows: the next step is a little worse.
constexpr double caution = 0.85;
/// A step that adds little more than it should is kept, and the next is shorter: to try it again would
/// cost a solve.
constexpr double little_more = 2.0;
/// From a step to the next. A two-step scheme is stable up to 1 + sqrt 2 (Hairer, Norsett & Wanner,
/// section III.5).
constexpr double largest_growth = 1.5, largest_shrinkage = 0.2;
/// Of a step that failed where its number has no limit that says by how much.
constexpr double after_failure = 0.5;
/// The limit that failed steps drew is tried anew, a little further each step.
constexpr double limit_growth = 1.01;
/// After which a step that is still too long is a failure of another kind.
constexpr int most_trials = 25;

/// A flame that swings is followed in so many steps a period: longer ones would not see it swing.
double ceiling(const Surface& surface) {
    constexpr double steps_a_period = 20.0;
    if (!surface.modulation) return std::numeric_limits<double>::infinity();
    return 1.0 / (steps_a_period * surface.modulation->frequency);
}

}  // namespace

ChosenSteps::ChosenSteps(const Scene& scene, const Grid& grid)
    : time_(scene.time),
      snapshots_every_(scene.output.snapshots_every),
      error_(scene, grid),
      crossing_(scene, grid),
      next_(scene.time.step),
      ceiling_(ceiling(scene.surface)),
      limit_(ceiling_) {}

void ChosenSteps::resume(const StepChoice& choice) {
    next_ = choice.next;
    limit_ = choice.limit;
    error_.resume(choice.memory);
    count_ = choice.count;
}

void ChosenSteps::advance(Simulation& simulation) {
    for (int trials = 1; !try_step(simulation, span_from(simulation.state().time), trials);)
        ++trials;
}

bool ChosenSteps::try_step(Simulation& simulation, const Span& span, int trials) {
    State before = simulation.state();
    try {
        take_step(simulation, span.end, span.length);
    } catch (const NumericalFailure& failure) {
        if (trials >= most_trials) throw;
        ++count_.failed;
        shorten(failure, span.length);
        return false;
    }
    const double error = error_.of(before, simulation.state()) / *time_.accuracy;
    const double crossed =
        crossing_.share_of_limit(crossing_.of(before.surface, simulation.state()));
    if ((error > little_more || crossed > 1.0) && trials < most_trials) {
        ++count_.rejected;
        next_ = span.length * std::min(change_for(error), crossed > 1.0 ? caution / crossed : 1.0);
        simulation.restore(std::move(before));
        return false;
    }
    error_.accept(before, simulation.state());
    accept(span.length, error, crossed);
    return true;
}

double ChosenSteps::change_for(double error) const {
    if (!(error > 0.0)) return largest_growth;
    return std::clamp(caution * std::pow(error, -1.0 / error_.order()), largest_shrinkage,
                      largest_growth);
}

void ChosenSteps::accept(double length, double error, double crossed) {
    const double change = change_for(error);
    double wanted = length * change;
    // A good step that was cut short says nothing against the length that was planned.
    if (change >= 1.0) wanted = std::max(wanted, std::min(next_, limit_));
    limit_ *= limit_growth;
    if (crossed > 0.0) limit_ = std::min(limit_, caution * length / crossed);
    next_ = std::min({wanted, limit_, ceiling_});
    count_.longest = std::max(count_.longest, length);
    count_.shortest = count_.shortest == 0.0 ? length : std::min(count_.shortest, length);
}

void ChosenSteps::shorten(const NumericalFailure& failure, double tried) {
    const FailureFields& fields = failure.fields();
    const bool has_limit = fields.kind == FailureFields::Kind::beyond_limit && fields.value &&
                           fields.limit && !fields.limit->is_least && fields.limit->value > 0.0;
    const double by = has_limit ? caution * fields.limit->value / *fields.value : after_failure;
    next_ = tried * std::clamp(by, largest_shrinkage, caution);
    limit_ = next_;
}

double ChosenSteps::next_stop(double now) const {
    if (!snapshots_every_) return time_.end;
    constexpr double grace = 1e-9;  // of an interval: a stop that has been reached is behind
    const double passed = std::floor(now / *snapshots_every_ + grace);
    return std::min((passed + 1.0) * *snapshots_every_, time_.end);
}

ChosenSteps::Span ChosenSteps::span_from(double now) const {
    const double stop = next_stop(now);
    const double left = stop - now;
    const double pieces = std::ceil(left / next_ - 1e-9);
    if (pieces <= 1.0) return {stop, left};
    // Far from a stop there is no need to share out what is left.
    const double length = pieces > 4.0 ? next_ : left / pieces;
    return {now + length, length};
}

long ChosenSteps::last_step(const State& state) const {
    return state.step + steps_over(time_.end - state.time, next_);
}

}  // namespace crawford
