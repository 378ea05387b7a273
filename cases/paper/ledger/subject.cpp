#include "cases/paper/ledger/subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/source_tree.hpp"
#include "cases/scenes/sandwich_measures.hpp"
#include "cases/units.hpp"
#include "solver/scene/read_scene.hpp"

namespace crawford::ledger {

using namespace units;

Scene Subject::scene(const Resolution& resolution, std::vector<std::string> set,
                     bool mechanics) const {
    const std::vector<std::string> of_resolution = {
        fmt::format("physics.mechanics={}", mechanics),
        fmt::format("physics.reference_map={}", mechanics),
        fmt::format("domain.nx={}", resolution.nx),
        fmt::format("domain.ny={}", resolution.ny),
        fmt::format("time.step={:g} us", resolution.step / us),
        fmt::format("time.end={:g} s", resolution.end)};
    set.insert(set.end(), of_resolution.begin(), of_resolution.end());
    Scene scene = read_scene(source_path("cases/scenes/" + file_), set);
    scene.time.until_steady.reset();
    scene.output = {.checkpoint_every = checkpoint_every_};
    return scene;
}

Scene Subject::coupled(const Resolution& resolution, const std::vector<std::string>& set) const {
    return scene(resolution, set, true);
}

Scene Subject::rigid(const Resolution& resolution, const std::vector<std::string>& set) const {
    return scene(resolution, set, false);
}

std::string text(const Resolution& r) {
    return fmt::format("{} x {} cells, steps of {:g} us, {:g} ms", r.nx, r.ny, r.step / us,
                       r.end / ms);
}

reports::Setting with(reports::Setting setting, const Resolution& r) {
    return setting.set("columns", long(r.nx))
        .set("rows", long(r.ny))
        .set("step", reports::Amount{r.step / us, "us"})
        .set("end", reports::Amount{r.end / ms, "ms"});
}

Finding finding(const Measure& measure, const Burn& burn, const std::string& prefix) {
    return {prefix + measure.what, measure.of(burn), measure.unit};
}

double mean(const std::vector<double>& course) {
    return std::accumulate(course.begin(), course.end(), 0.0) / double(course.size());
}

double deviation(const std::vector<double>& values) {
    double squares = 0.0;
    for (const double value : values) squares += std::pow(value - mean(values), 2);
    return std::sqrt(squares / double(values.size() - 1));
}

namespace {

/// Heights of the surface from side to side [m].
std::vector<double> heights(const Burn& burn) {
    std::vector<double> heights;
    const int top = burn.last.position.rows() - 1;
    for (int i = 0; i < burn.last.position.columns(); ++i)
        heights.push_back(burn.last.position(i, top).y());
    return heights;
}

}  // namespace

constinit const Measure mean_burn_rate_of_all{
    "mean burn rate", "cm/s", [](const Burn& b) { return mean(b.mean_burn_rate) / (cm / s); }};
constinit const Measure regression_rate_of_all{
    "regression rate", "cm/s", [](const Burn& b) { return mean(b.regression_rate) / (cm / s); }};
constinit const Measure mean_temperature{"mean of the largest temperature", "K",
                                         [](const Burn& b) { return mean(b.largest_temperature); }};
constinit const Measure mean_strain{"mean of the largest strain", "-",
                                    [](const Burn& b) { return mean(b.largest_strain); }};
constinit const Measure mean_strain_about_peak{
    "mean of the strain over 5 um about its peak", "-",
    [](const Burn& b) { return mean(b.strain_about_peak); }};
constinit const Measure mean_pressure_about_peak{
    "mean of the pressure over 5 um about its peak", "MPa",
    [](const Burn& b) { return mean(b.pressure_about_peak) / MPa; }};
constinit const Measure relief{"relief of the surface at the end", "um", [](const Burn& b) {
                                   const auto [low, high] = std::ranges::minmax(heights(b));
                                   return (high - low) / um;
                               }};

constinit const Measure last_burn_rate{
    "mean burn rate", "cm/s", [](const Burn& b) { return b.mean_burn_rate.back() / (cm / s); }};
constinit const Measure last_regression_rate{
    "regression rate", "cm/s", [](const Burn& b) { return b.regression_rate.back() / (cm / s); }};
constinit const Measure last_temperature{
    "largest temperature", "K", [](const Burn& b) { return b.largest_temperature.back(); }};
constinit const Measure last_strain{"largest strain", "-",
                                    [](const Burn& b) { return b.largest_strain.back(); }};
constinit const Measure last_strain_about_peak{
    "strain over 5 um about its peak", "-",
    [](const Burn& b) { return b.strain_about_peak.back(); }};
constinit const Measure last_pressure_about_peak{
    "pressure over 5 um about its peak", "MPa",
    [](const Burn& b) { return b.pressure_about_peak.back() / MPa; }};
constinit const Measure outward_displacement{
    "largest outward displacement", "um",
    [](const Burn& b) { return largest_outward_displacement(b.last) / um; }};
constinit const Measure height_of_profile{"height of the profile above the edge", "um",
                                          [](const Burn& b) {
                                              const auto h = heights(b);  // from the axis outwards
                                              return (std::ranges::max(h) - h.back()) / um;
                                          }};

std::vector<Measure> pack_measures() {
    return {mean_burn_rate_of_all,
            regression_rate_of_all,
            mean_temperature,
            mean_strain,
            mean_strain_about_peak,
            mean_pressure_about_peak,
            relief};
}

std::vector<Measure> rigid_pack_measures() {
    return {mean_burn_rate_of_all, regression_rate_of_all, mean_temperature, relief};
}

std::vector<Measure> sandwich_measures() {
    return {last_burn_rate,       last_regression_rate,   last_temperature,
            last_strain,          last_strain_about_peak, last_pressure_about_peak,
            outward_displacement, height_of_profile};
}

std::vector<Measure> rigid_sandwich_measures() {
    return {last_burn_rate, last_regression_rate, last_temperature, height_of_profile};
}

reports::Measurement measured(const Burn& burn, const std::vector<Measure>& measures) {
    reports::Measurement found;
    for (const Measure& measure : measures)
        found.value(measure.what, reports::Amount{measure.of(burn), measure.unit});
    return found;
}

}  // namespace crawford::ledger
