#include "solver/run/burn.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "base/room.hpp"
#include "solver/files/checkpoint.hpp"
#include "solver/files/manifest.hpp"
#include "solver/guards/predicted.hpp"
#include "solver/guards/watch.hpp"
#include "solver/run/history_row.hpp"
#include "solver/run/loop.hpp"
#include "solver/run/recorder.hpp"
#include "solver/run/steadiness.hpp"
#include "solver/scene/read_pack.hpp"
#include "solver/scene/write_scene.hpp"

namespace crawford {

namespace {

std::vector<std::uint64_t> seeds_of(const Scene& scene) {
    const auto* discs = std::get_if<Discs>(&scene.morphology.shape);
    const auto seed = discs == nullptr ? std::nullopt : seed_of(discs->source);
    return seed ? std::vector{*seed} : std::vector<std::uint64_t>();
}

using Outcome = ManifestOutcome::Kind;

class Run {
public:
    Run(const Reduction& reduction, const BurnOptions& options, const Sources& sources)
        : options_(options),
          reduction_(reduction),
          simulation_(reduction.scene, sources),
          steps_(steps_of(simulation_)),
          watch_(simulation_),
          steadiness_(reduction.scene) {
        const Scene& scene = reduction.scene;
        manifest_.scene = to_toml(reduction.asked);
        manifest_.left_out = reduction.left_out;
        manifest_.predicted = predicted(scene);
        refuse(manifest_.predicted);
        if (options.restart) restart(*options.restart);
        prepare_directory(options.directory);
        manifest_.command = options.command;
        manifest_.seeds = seeds_of(scene);
        manifest_.first_step = simulation_.state().step;
        manifest_.started = std::chrono::system_clock::now();
    }

    BurnOutcome to_the_end() {
        write({Outcome::running});
        tell(manifest_.predicted);
        Recorder recorder(options_.directory, options_.name, reduction_, simulation_);
        try {
            advance(recorder);
        } catch (const NumericalFailure& failure) {
            give_up(recorder, failure);
        } catch (const InputError& problem) {
            note_end({Outcome::cut_off, problem.what()});
            throw;
        } catch (const std::exception& problem) {
            note_end(is_out_of_memory(std::current_exception())
                         ? ManifestOutcome{Outcome::cut_off, "out of memory"}
                         : ManifestOutcome{Outcome::failed, problem.what()});
            throw;
        }
        const auto checkpoint = recorder.keep(simulation_, memory());
        if (!interrupted_) manifest_.results = results();
        write({interrupted_ ? Outcome::interrupted : Outcome::done});
        return outcome(checkpoint);
    }

private:
    using Clock = std::chrono::steady_clock;

    void tell(const Guards& guards) const {
        if (!options_.remark) return;
        for (const Guard& guard : remarks(guards)) options_.remark(guard);
    }

    /// Tells what has not been foretold.
    void tell_news(const Guards& met) const {
        for (const Guard& guard : met) {
            const auto foretold = std::ranges::find(manifest_.predicted, guard.name, &Guard::name);
            if (foretold == manifest_.predicted.end() || foretold->beyond != Beyond::remark)
                tell({guard});
        }
    }

    void restart(const std::filesystem::path& file) {
        Checkpoint checkpoint = load_checkpoint(file, to_toml(reduction_.scene));
        simulation_.restore(std::move(checkpoint.state));
        watch_ = Watch(simulation_);
        steadiness_.resume(checkpoint.memory.window);
        if (checkpoint.memory.choice) steps_->resume(*checkpoint.memory.choice);
        manifest_.restarted_from = file.string();
        if (steps_->at_the_end(simulation_.state()))
            throw InputError(
                fmt::format("{} is at {} s, which is not before time.end = {} s; set "
                            "a later time.end",
                            file.string(), simulation_.state().time, simulation_.scene().time.end));
    }

    void advance(Recorder& recorder) {
        const State& state = simulation_.state();
        Summary summary;
        const Observer summarise = [&](Simulation& simulation, double) {
            summary = simulation.summary();
            steadiness_.record(state, summary);
            tell_news(watch_.record(simulation, summary));
        };
        const Observer record = [&](Simulation& simulation, double before) {
            recorder.record(simulation, summary, before, memory());
        };
        const Observer show = [&](Simulation&, double) {
            if (options_.watch)
                options_.watch({manifest_.first_step,
                                steps_->last_step(state),
                                {state.step, state.time, summary.mean_burn_rate}});
        };
        const Stop ended = [&](const Simulation& simulation) {
            if (steps_->at_the_end(simulation.state()) || steadiness_.reached()) return true;
            interrupted_ = options_.interrupted && options_.interrupted();
            return interrupted_;
        };
        run_until(simulation_, *steps_, ended, {summarise, record, show});
    }

    /// A number beyond its limit says more than the place where a run has ended of it.
    NumericalFailure explained(const NumericalFailure& failure) const {
        for (const Guards& known : {manifest_.predicted, watch_.met()})
            for (const Guard& beyond : remarks(known)) return because_of(failure, in_words(beyond));
        return failure;
    }

    /// Keeps the last good state and says where.
    [[noreturn]] void give_up(Recorder& recorder, const NumericalFailure& ended) {
        const NumericalFailure failure = explained(ended);
        std::string kept;
        try {
            kept =
                "the last good state is kept in " + recorder.keep(simulation_, memory()).string();
            write({Outcome::failed, failure.what()});
        } catch (const InputError& error) {
            kept = fmt::format("the last good state is lost: {}", error.what());
        }
        throw with_advice(failure, kept);
    }

    RunMemory memory() const { return {steadiness_.window(), steps_->choice()}; }

    /// Says in the manifest how it ended, as far as anything can still be written.
    void note_end(const ManifestOutcome& how) {
        try {
            write(how);
        } catch (const InputError&) {
            // The disk is full, say: what has gone wrong before is told, and that is the cause.
        }
    }

    void write(const ManifestOutcome& outcome) {
        manifest_.outcome = outcome;
        manifest_.met = watch_.met();
        manifest_.last_step = simulation_.state().step;
        manifest_.time = simulation_.state().time;
        if (const auto choice = steps_->choice()) manifest_.steps = choice->count;
        manifest_.ended = std::chrono::system_clock::now();
        manifest_.wall_seconds = std::chrono::duration<double>(Clock::now() - started_).count();
        write_manifest(options_.directory / "manifest.json", manifest_);
    }

    RunResults results() const {
        const HistoryRow row = history_row(simulation_, simulation_.summary(), reduction_.widening);
        const Scene& scene = simulation_.scene();
        RunResults results{.regression_rate = row.regression_rate,
                           .mean_burn_rate = row.mean_burn_rate,
                           .largest_temperature = row.largest_temperature};
        if (scene.physics.reference_map) results.strain_about_peak = row.strain_about_peak;
        if (scene.time.until_steady) results.steady = steadiness_.reached();
        return results;
    }

    BurnOutcome outcome(const std::filesystem::path& checkpoint) const {
        const State& state = simulation_.state();
        const std::chrono::duration<double> wall = Clock::now() - started_;
        return {.step = state.step,
                .time = state.time,
                .steady = steadiness_.reached(),
                .interrupted = interrupted_,
                .summary = simulation_.summary(),
                .seconds = wall.count(),
                .steps = state.step - manifest_.first_step,
                .chosen = manifest_.steps,
                .timing = simulation_.timing(),
                .checkpoint = checkpoint};
    }

    const BurnOptions& options_;
    const Reduction& reduction_;
    Clock::time_point started_ = Clock::now();
    Simulation simulation_;
    std::unique_ptr<Steps> steps_;
    Watch watch_;
    Steadiness steadiness_;
    Manifest manifest_;
    bool interrupted_ = false;
};

}  // namespace

BurnOutcome burn(const Reduction& reduction, const BurnOptions& options, const Sources& sources) {
    return Run(reduction, options, sources).to_the_end();
}

BurnOutcome burn(const Scene& scene, const BurnOptions& options, const Sources& sources) {
    return burn(as_written(scene), options, sources);
}

}  // namespace crawford
