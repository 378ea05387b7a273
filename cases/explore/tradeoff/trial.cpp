#include "cases/explore/tradeoff/trial.hpp"

#include <algorithm>
#include <cmath>

#include "base/source_tree.hpp"
#include "solver/guards/predicted.hpp"
#include "solver/run/history_row.hpp"
#include "solver/run/loop.hpp"
#include "solver/scene/read_scene.hpp"

namespace crawford::tradeoff {

namespace {

/// Means over the time that is looked at.
class Means {
public:
    explicit Means(const Subject& subject) : from_(subject.from), to_(subject.to) {}

    void add(const HistoryRow& row) {
        const double length = std::min(row.time, to_) - std::max(row.time - row.step, from_);
        if (length <= 0.0) return;
        sums_.regression_rate += length * row.regression_rate;
        sums_.mean_burn_rate += length * row.mean_burn_rate;
        sums_.largest_temperature += length * row.largest_temperature;
        sums_.strain_about_peak += length * row.strain_about_peak;
        sums_.pressure_about_peak += length * row.pressure_about_peak;
        time_ += length;
    }
    double of(double HistoryRow::*member) const { return sums_.*member / time_; }

private:
    double from_, to_;
    HistoryRow sums_{};
    double time_ = 0.0;
};

/// Height of the surface at x [m], along straight lines between nodes, beyond the sides again.
double height(const Grid& grid, const SurfaceField& surface, double x) {
    const int columns = grid.cell_columns();
    int i = 0;
    while (i + 1 < columns && grid.x(i + 1) < x) ++i;
    const double left = surface[size_t(i)];
    const double right = surface[size_t(i + 1) % surface.size()];
    return left + (right - left) * (x - grid.x(i)) / (grid.x(i + 1) - grid.x(i));
}

/// Heights about their mean, at points that all grids share.
reports::Sample profile(const Simulation& simulation, int points) {
    const Grid& grid = simulation.grid();
    const double left = grid.x(0);
    const double width = grid.x(grid.cell_columns()) - left;
    const double mean = mean_height(grid, simulation.state().surface);
    reports::Sample sample;
    for (int k = 0; k < points; ++k)
        sample.values.push_back(
            height(grid, simulation.state().surface, left + (k + 0.5) / points * width) - mean);
    return sample;
}

}  // namespace

Scene scene_of(const Subject& subject, const Trial& trial) {
    std::vector<std::string> changes = subject.changes;
    changes.insert(changes.end(), trial.changes.begin(), trial.changes.end());
    return read_scene(source_path("cases/scenes/" + subject.file), changes);
}

reports::Setting setting_of(const Trial& trial) {
    reports::Setting setting;
    setting.set("subject", trial.subject);
    for (const std::string& change : trial.changes) {
        const size_t equals = change.find('=');
        setting.set(change.substr(0, equals), change.substr(equals + 1));
    }
    return setting;
}

reports::Measurement measure(const Subject& subject, const Trial& trial) {
    const Scene scene = scene_of(subject, trial);
    refuse(predicted(scene));
    Simulation simulation(scene);
    Means means(subject);
    run_to_end(simulation, {[&](Simulation& now, double) {
                   means.add(history_row(now, now.summary(), Widening()));
               }});
    reports::Measurement found;
    found.value(quantity::regression_rate, {means.of(&HistoryRow::regression_rate), "m/s"})
        .value(quantity::mean_burn_rate, {means.of(&HistoryRow::mean_burn_rate), "m/s"})
        .value(quantity::max_temperature, {means.of(&HistoryRow::largest_temperature), "K"});
    if (scene.physics.reference_map)
        found.value(quantity::strain, {means.of(&HistoryRow::strain_about_peak), "-"});
    if (scene.physics.mechanics)
        found.value(quantity::pressure, {means.of(&HistoryRow::pressure_about_peak), "Pa"});
    if (subject.profile > 0) found.sample(quantity::profile, profile(simulation, subject.profile));
    return found;
}

}  // namespace crawford::tradeoff
