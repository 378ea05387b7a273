/// # Speed for accuracy: what do I lose if I want it ten times faster?
///
/// A slab, a sandwich (rigid and with stress) and a pack are burnt in many ways: one knob at a time
/// about a usual setting, and several at once. Each burn is timed by itself, one after the other,
/// and held against the exact slab, the free-boundary problem of the rigid sandwich, or, for what no
/// theory has, a run beyond all others. What that run differs by from its check, on half the grid, is
/// shown as a band: a point within it is as good as can be told.
///
/// Errors are of what a run is asked for between two times late in the burn: the regression rate V,
/// the mean burn rate, the largest temperature, strain and pressure within 5 um of their maxima (each
/// relative), and the shape of the surface (root mean square in um). Runs that were refused or
/// failed are points as well: they have cost what they have cost.
///
/// A line joins what nothing beats: no other setting is both cheaper and more accurate. The presets
/// of `crawford burn --accuracy` are taken from there (docs/trade.md).
///
/// What not to conclude. Seconds are those of one core of one machine. A point may lie low by chance, where two
/// errors cancel: the line is to be read with the points beside it. And "physics" is no error of
/// numbers: a rigid sandwich is another solid.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "base/atomic_file.hpp"
#include "base/build_info.hpp"
#include "base/peak_memory.hpp"
#include "cases/explore/tradeoff/judged.hpp"
#include "cases/explore/tradeoff/trials.hpp"
#include "cases/registry.hpp"
#include "cases/scene_fingerprint.hpp"
#include "reports/pareto.hpp"
#include "reports/record_store.hpp"

namespace crawford {

namespace {

using namespace tradeoff;
using Json = nlohmann::ordered_json;

constexpr auto experiment = "tradeoff, burns";
constexpr std::array quantities{quantity::regression_rate, quantity::mean_burn_rate,
                                quantity::max_temperature, quantity::strain,
                                quantity::pressure,        quantity::profile};

const Subject& named(const std::vector<Subject>& subjects, const std::string& name) {
    return *std::ranges::find(subjects, name, &Subject::name);
}

/// The record of a trial: one that is there, of this very program, or a new one.
reports::Record record_of(const Subject& subject, const Trial& trial, const std::string& fidelity,
                          reports::RecordStore& store) {
    const reports::Setting setting = setting_of(trial).set("fidelity", fidelity);
    const auto kept = store.newest(experiment, setting);
    if (kept && kept->fingerprint == store.fingerprint()) return *kept;
    forget_peak_memory();
    reports::Record record = reports::record_of(
        experiment, setting, [&](const reports::Setting&) { return measure(subject, trial); });
    record.fingerprint = store.fingerprint();
    store.add(record);
    return record;
}

/// One after the other: side by side they would slow each other down.
std::vector<Point> burn_all(const Request& request, const std::vector<Subject>& subjects) {
    const std::string fidelity = request.fidelity == Fidelity::draft ? "draft" : "paper";
    reports::RecordStore store(request.out / "records", fingerprint_with_scenes());
    std::vector<Point> points;
    const std::vector<Trial> all = trials(request.fidelity);
    for (const Trial& trial : all) {
        const Subject& subject = named(subjects, trial.subject);
        points.push_back({trial, record_of(subject, trial, fidelity, store), {}});
        if (request.progress)
            request.progress("tradeoff", double(points.size()) / double(all.size()));
    }
    return points;
}

double error(const Point& point, const std::string& quantity) {
    const auto found = point.errors.find(quantity);
    return found == point.errors.end() ? std::nan("") : found->second;
}

/// A rigid solid in place of one with stress is another answer, and the truth its own.
bool competes(const Point& point) {
    return point.trial.knob != "physics" && point.trial.knob != "truth" &&
           point.trial.knob != "check of the truth";
}

/// Places in `points` of the front of a subject and a quantity.
std::vector<size_t> front(const std::vector<Point>& points, const std::string& subject,
                          const std::string& quantity) {
    std::vector<reports::Traded> traded;
    for (const Point& point : points) {
        const bool counts = point.trial.subject == subject && competes(point);
        traded.push_back(
            {point.record.cost.cpu_seconds, counts ? error(point, quantity) : std::nan("")});
    }
    return reports::pareto_front(traded);
}

std::string words_of(const Trial& trial) {
    return trial.changes.empty() ? "as it is" : fmt::format("{}", fmt::join(trial.changes, ", "));
}

Json json_of(const Point& point) {
    Json setting;
    for (const auto& [axis, value] : point.record.setting.axes())
        setting[axis] = reports::text(value);
    Json errors = Json::object();
    for (const auto& [name, value] : point.errors) errors[name] = value;
    return {{"subject", point.trial.subject},
            {"knob", point.trial.knob},
            {"setting", setting},
            {"error", errors},
            {"seconds", point.record.cost.cpu_seconds},
            {"MB", double(point.record.cost.peak_memory_bytes) / 1e6},
            {"steps", point.record.cost.work.steps},
            {"outcome", reports::name(point.record.ending.kind)},
            {"said", point.record.ending.message}};
}

void write_json(const std::filesystem::path& out, const std::vector<Subject>& subjects,
                const std::vector<Point>& points, const std::map<std::string, Truth>& truths) {
    Json json{{"revision", revision()},
              {"points", Json::array()},
              {"fronts", Json::array()},
              {"truths", Json::array()}};
    for (const Point& point : points) json["points"].push_back(json_of(point));
    for (const Subject& subject : subjects) {
        const Truth& truth = truths.at(subject.name);
        json["truths"].push_back({{"subject", subject.name},
                                  {"source", truth.source},
                                  {"values", truth.values},
                                  {"uncertainty", truth.uncertainty}});
        for (const char* quantity : quantities)
            if (const auto places = front(points, subject.name, quantity); !places.empty())
                json["fronts"].push_back(
                    {{"subject", subject.name}, {"quantity", quantity}, {"points", places}});
    }
    write_file(out / "figures" / "tradeoff.json", json.dump(2) + '\n');
}

/// Colour of a point: what kind of knob it turns.
int group(const std::string& knob) {
    const std::vector<std::vector<std::string>> groups{
        {"as it is"},
        {"columns", "rows", "clustering of rows", "clustering of columns", "half"},
        {"step", "step, by itself", "scheme"},
        {"linear solver", "solver tolerance", "heat tolerance"},
        {"element", "coupling", "front", "reference map"},
        {"several at once"}};
    for (size_t k = 0; k < groups.size(); ++k)
        if (std::ranges::find(groups[k], knob) != groups[k].end()) return int(k);
    return -1;
}

/// "sandwich_rigid" of "sandwich, rigid".
std::string table_name(const std::string& subject) {
    std::string name;
    for (const char c : subject)
        if (c == ' ')
            name += '_';
        else if (c != ',')
            name += c;
    return name;
}

void add_points(reports::Figure& figure, const Subject& subject, const std::vector<Point>& points) {
    reports::Column kind{"group", "-", {}}, seconds{"seconds", "s", {}}, off{"V off by", "%", {}};
    reports::Column lost{"seconds", "s", {}}, why{"refused or failed", "-", {}};
    for (const Point& point : points) {
        if (point.trial.subject != subject.name || !competes(point)) continue;
        if (point.errors.empty()) {
            lost.values.push_back(std::max(point.record.cost.cpu_seconds, 1e-3));
            why.values.push_back(point.record.ending.kind == reports::Ending::Kind::failed);
            continue;
        }
        kind.values.push_back(group(point.trial.knob));
        seconds.values.push_back(point.record.cost.cpu_seconds);
        off.values.push_back(100.0 * error(point, quantity::regression_rate));
    }
    // The script draws the kinds that there are: a plot without a point is a fault to it.
    const std::set<double> kinds(kind.values.begin(), kind.values.end());
    figure.set("kinds_" + table_name(subject.name), fmt::format("{}", fmt::join(kinds, " ")));
    figure.table(table_name(subject.name), {kind, seconds, off});
    figure.set("lost_" + table_name(subject.name), double(lost.values.size()));
    if (!lost.values.empty()) figure.table(table_name(subject.name) + "_lost", {lost, why});
}

void add_fronts(reports::Figure& figure, const Subject& subject, const std::vector<Point>& points) {
    for (size_t q = 0; q < quantities.size(); ++q) {
        const bool relative = quantities[q] != std::string(quantity::profile);
        reports::Column seconds{"seconds", "s", {}};
        reports::Column off{quantities[q] + std::string(" off by"), relative ? "%" : "um", {}};
        for (const size_t place : front(points, subject.name, quantities[q])) {
            seconds.values.push_back(points[place].record.cost.cpu_seconds);
            off.values.push_back((relative ? 100.0 : 1.0) * error(points[place], quantities[q]));
        }
        if (seconds.values.empty()) continue;  // nothing to hold it against
        figure.table(fmt::format("{}_front_{}", table_name(subject.name), q), {seconds, off});
    }
}

/// The least error within a time, of what lies on the front; NaN if nothing is that fast.
double best_within(double seconds, const std::vector<Point>& points, const std::string& subject) {
    double best = std::nan("");
    for (const size_t place : front(points, subject, quantity::regression_rate))
        if (points[place].record.cost.cpu_seconds <= seconds)
            best = error(points[place], quantity::regression_rate);
    return best;
}

/// What a user asks first: how fast for 1 % and 0.1 %, what ten times faster costs, and what each kind of
/// physics does.
void find(Outcome& outcome, const Subject& subject, const std::vector<Point>& points,
          const Truth& truth) {
    const auto add = [&](const std::string& what, double value, const std::string& unit) {
        outcome.findings.push_back({subject.name + ": " + what, value, unit});
    };
    const auto own = [&](const Point& p) { return p.trial.subject == subject.name; };
    const auto usual = std::ranges::find_if(
        points, [&](const Point& p) { return own(p) && p.trial.knob == "as it is"; });
    const double seconds = usual->record.cost.cpu_seconds;
    add("as it is", seconds, "s");
    add("as it is, V off by", 100.0 * error(*usual, quantity::regression_rate), "%");
    const double fast = best_within(seconds / 10.0, points, subject.name);
    if (std::isfinite(fast)) add("ten times faster, V off by", 100.0 * fast, "%");
    for (const double wanted : {0.01, 0.001})
        for (const size_t place : front(points, subject.name, quantity::regression_rate))
            if (error(points[place], quantity::regression_rate) <= wanted) {
                add(fmt::format("V to {:g} %, with {}", 100.0 * wanted,
                                words_of(points[place].trial)),
                    points[place].record.cost.cpu_seconds, "s");
                break;
            }
    if (const auto band = truth.uncertainty.find(quantity::regression_rate);
        band != truth.uncertainty.end())
        add("V of the truth known to", 100.0 * band->second, "%");
    add("as it is, memory", double(usual->record.cost.peak_memory_bytes) / 1e6, "MB");
    for (const Point& point : points) {
        const std::string& knob = point.trial.knob;
        if (!own(point) || (knob != "physics" && knob != "reference map")) continue;
        const std::string without = "physics: with " + words_of(point.trial);
        add(without, point.record.cost.cpu_seconds, "s");
        add(without + ", memory", double(point.record.cost.peak_memory_bytes) / 1e6, "MB");
    }
}

Outcome draw(const Request& request) {
    const std::vector<Subject> all = subjects(request.fidelity);
    std::vector<Point> points = burn_all(request, all);
    Outcome outcome{reports::Figure("tradeoff", request.out), {}, {}};
    std::map<std::string, Truth> truths;
    for (const Subject& subject : all) {
        const Truth& truth = truths[subject.name] = truth_of(subject, points);
        for (Point& point : points)
            if (point.trial.subject == subject.name && point.record.found)
                point.errors = errors_of(*point.record.found, truth);
        add_points(outcome.figure, subject, points);
        add_fronts(outcome.figure, subject, points);
        find(outcome, subject, points, truth);
        const auto band = truth.uncertainty.find(quantity::regression_rate);
        outcome.figure.set("band_" + table_name(subject.name),
                           band == truth.uncertainty.end() ? 0.0 : 100.0 * band->second);
        outcome.scenes.push_back(scene_of(subject, {}));
    }
    write_json(request.out, all, points, truths);
    outcome.figure.caption({.grid = "each point has its own",
                            .step = "each point has its own",
                            .revision = revision(),
                            .note = "CPU seconds of one core, one burn at a time"});
    for (const char* panel : {"a", "b", "c", "d", "e", "f"}) outcome.figure.panel(panel);
    return outcome;
}

const Registered here{
    {.name = "tradeoff",
     .figure = "-",
     .shows = "error against cost over every knob: what ten times faster loses",
     .physics = {physics::heat, physics::coupling, physics::slab, physics::sandwich, physics::pack},
     .cost = {.draft = 90.0, .paper = 1800.0},
     .draw = draw}};

}  // namespace

}  // namespace crawford
