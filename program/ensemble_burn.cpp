#include "program/ensemble_burn.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/digest.hpp"
#include "base/errors.hpp"
#include "solver/files/history.hpp"
#include "solver/packing/pack.hpp"
#include "solver/run/run_identity.hpp"
#include "solver/scene/readings.hpp"

namespace crawford {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double centimetre = 1e-2;

/// The period follows from the fraction and is rounded: nine digits are more than anyone asks for.
double rounded(double fraction) {
    return std::round(fraction * 1e9) / 1e9;
}

double fraction_of(const Scene& scene) {
    const auto* discs = std::get_if<Discs>(&scene.morphology.shape);
    return discs == nullptr ? none : rounded(area_fraction(*discs, scene.domain.width));
}

std::string readings_of(const Scene& scene) {
    const auto readings = readings_of(scene.physics, scene.numerics);
    if (!readings) return "of its own";
    return *readings == Readings::paper ? "paper" : "consistent";
}

/// All but where the discs lie.
std::string shared(Scene scene) {
    std::vector<double> radii;
    const double fraction = fraction_of(scene);
    if (const auto* discs = std::get_if<Discs>(&scene.morphology.shape)) {
        for (const auto& disc : discs->discs) radii.push_back(disc.radius);
        std::ranges::sort(radii);
        scene.morphology.shape = Uniform{};
    }
    return digest(fmt::format("{}{}{}", identity_of(scene), fraction, fmt::join(radii, " ")));
}

struct Course {
    double time = 0.0, burnt = 0.0, rate = 0.0;  ///< time counted [s], integrals over it
    double temperature = 0.0, strain = 0.0;      ///< largest

    void add(const HistoryRow& row, double length) {
        time += length;
        burnt += length * row.regression_rate;
        rate += length * row.mean_burn_rate;
        temperature = std::max(temperature, row.largest_temperature);
        strain = std::max(strain, row.strain_about_peak);
    }
};

/// A row stands for the time since the row before it.
Course course_of(const FoundRun& run, double after) {
    const auto rows = read_history(run.folder / (run.name + "_history.csv"));
    Course course;
    double before = 0.0;
    for (const HistoryRow& row : rows) {
        if (row.time > after) course.add(row, row.time - std::max(before, after));
        before = row.time;
    }
    if (course.time == 0.0)
        throw InputError(
            fmt::format("{} ends at {:g} ms, not after {:g} ms; give --after an "
                        "earlier time",
                        run.folder.string(), 1e3 * before, 1e3 * after));
    return course;
}

}  // namespace

reports::EnsembleBurn ensemble_burn(const FoundRun& run, const std::optional<double>& after) {
    const Scene& scene = *run.scene;
    reports::EnsembleBurn burn{.key = run.key,
                               .rest = shared(scene),
                               .conditions = {.area_fraction = fraction_of(scene),
                                              .pressure = scene.surface.pressure,
                                              .readings = readings_of(scene),
                                              .columns = scene.domain.nx,
                                              .rows = scene.domain.ny,
                                              .end = scene.time.end,
                                              .after = after.value_or(0.5 * scene.time.end)},
                               .seed = fmt::format("{}", fmt::join(run.seeds, " ")),
                               .state = name_of(run.state),
                               .reason = run.reason,
                               .values = {none, none, none, none}};
    if (run.state != RunState::done) return burn;
    const Course course = course_of(run, burn.conditions.after);
    burn.values = {course.burnt / course.time / centimetre, course.rate / course.time / centimetre,
                   course.temperature, scene.physics.reference_map ? course.strain : none};
    return burn;
}

}  // namespace crawford
