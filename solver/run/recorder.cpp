#include "solver/run/recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/build_info.hpp"
#include "solver/run/history_row.hpp"
#include "solver/scene/write_scene.hpp"

namespace crawford {

namespace {

/// The row of a last state that was not due is dropped: the unbroken run has none.
History open_history(const std::filesystem::path& path, const State& state, int every) {
    if (state.step == 0) return History::start(path);
    const bool due = state.step % every == 0;
    return History::resume(path, due ? state.time : state.time - 0.5 * state.length);
}

Provenance provenance_of(const Scene& scene) {
    return {to_toml(scene), version(), revision()};
}

}  // namespace

bool is_due(double before, double after, double interval) {
    constexpr double grace = 1e-6;  // of an interval: times are sums of steps
    return std::floor(after / interval + grace) > std::floor(before / interval + grace);
}

Recorder::Recorder(std::filesystem::path directory, std::string name, const Reduction& reduction,
                   const Simulation& simulation)
    : directory_(std::move(directory)),
      name_(std::move(name)),
      widening_(reduction.widening),
      computed_(provenance_of(reduction.scene)),
      output_(simulation.scene().output),
      history_(open_history(directory_ / (name_ + "_history.csv"), simulation.state(),
                            output_.history_every)),
      snapshots_(directory_, name_, provenance_of(reduction.asked)) {
    if (simulation.state().step > 0)
        snapshots_.resume(simulation.state().time);
    else if (output_.snapshots_every)
        take_snapshot(simulation);
}

void Recorder::record(Simulation& simulation, const Summary& summary, double before,
                      const RunMemory& memory) {
    const State& state = simulation.state();
    owes_a_row_ = state.step % output_.history_every != 0;
    if (!owes_a_row_) history_.append(history_row(simulation, summary, widening_));
    if (output_.snapshots_every && is_due(before, state.time, *output_.snapshots_every))
        take_snapshot(simulation);
    if (output_.checkpoint_every && is_due(before, state.time, *output_.checkpoint_every)) {
        take_checkpoint(simulation, memory);
        simulation.forget_factorisation();
    }
}

std::filesystem::path Recorder::keep(const Simulation& simulation, const RunMemory& memory) {
    if (std::exchange(owes_a_row_, false))
        history_.append(history_row(simulation, simulation.summary(), widening_));
    if (simulation.state().step != last_snapshot_) take_snapshot(simulation);
    return take_checkpoint(simulation, memory);
}

void Recorder::take_snapshot(const Simulation& simulation) {
    snapshots_.write(widening_.whole(collect_snapshot(simulation)));
    last_snapshot_ = simulation.state().step;
}

std::filesystem::path Recorder::take_checkpoint(const Simulation& simulation,
                                                const RunMemory& memory) {
    const State& state = simulation.state();
    auto path = checkpoint_file(directory_, name_, state.step);
    save_checkpoint(path, {state, memory}, computed_);
    return path;
}

}  // namespace crawford
