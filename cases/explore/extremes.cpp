/// # Extremes: where does an answer stand, and does the program know it?
///
/// Settings far from the paper's, on maps over two axes each. Every one is burnt as it is asked for,
/// also where it is refused, and again much finer: at least twice the columns and rows, half the
/// step, a window that the bottom does not cool, and finer still until no number of docs/limits.md
/// is near its limit. An answer is off where burnt depth or regression rate differ by more than 2 %
/// (of a surface that is not yet alight: its temperature).
///
/// - `right`: nothing was said, and it is not off.
/// - `remarked`: the program said that it is inaccurate, or means something else than it seems to.
/// - `refused`: not begun, or not burnt to its end, with the reason. Ringed where it is right when it is
///   burnt all the same.
/// - `wrong`: off without a word. There must be none.
///
/// Lines are limits that theory gives, computed from the scene alone (docs/limits.md says where each
/// comes from). Under each map stands at how many of its points theory and outcome agree: beyond a
/// line an answer is expected to be off or not to end, within all lines to be right. Beyond and yet
/// right is no contradiction: a layer that is not resolved may still end at the right depth.
///
/// Each point is a record of its own, so what was cut off goes on; extremes.json holds them all.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "base/build_info.hpp"
#include "cases/explore/extreme_maps.hpp"
#include "cases/explore/extreme_records.hpp"
#include "cases/registry.hpp"

namespace crawford {

namespace {

std::vector<ExtremeMap> all_maps() {
    std::vector<ExtremeMap> maps = maps_of_slabs();
    std::ranges::move(maps_of_sandwiches(), std::back_inserter(maps));
    return maps;
}

using Points = std::vector<JudgedPoint>;

Points judged(const ExtremeMap& map, Fidelity fidelity, reports::RecordStore& store) {
    Points points;
    for (const ExtremePoint& point : points_of(map, fidelity == Fidelity::draft))
        points.push_back(judged(point, store));
    return points;
}

long count(const Points& points, Standing standing) {
    return std::ranges::count(points, standing, &JudgedPoint::standing);
}

/// What theory expects of the points of a map, and what becomes of them.
struct Agreement {
    long beyond_and_off = 0, within_and_right = 0, beyond_and_right = 0, within_and_off = 0;

    Agreement(const ExtremeMap& map, const Points& points) {
        for (const JudgedPoint& judged : points) {
            const Scene scene = judged.point.scene();
            const bool is_beyond = std::ranges::any_of(
                map.limits, [&](const ExtremeLimit& limit) { return beyond(limit, scene) > 1.0; });
            if (judged.is_sound())
                ++(is_beyond ? beyond_and_right : within_and_right);
            else
                ++(is_beyond ? beyond_and_off : within_and_off);
        }
    }
    long agree() const { return beyond_and_off + within_and_right; }
    long all() const { return agree() + beyond_and_right + within_and_off; }
    std::string text() const {
        return fmt::format(
            "theory and outcome agree at {} of {} points: {} beyond a line and off, {} within and "
            "right; {} beyond yet right, {} within yet off",
            agree(), all(), beyond_and_off, within_and_right, beyond_and_right, within_and_off);
    }
};

/// What the script knows of the mark of a point.
double mark(const JudgedPoint& judged) {
    constexpr double needlessly = 4.0;
    return judged.needlessly ? needlessly : double(judged.standing);
}

void add_limits(reports::Figure& figure, const ExtremeMap& map) {
    int drawn = 0;
    for (const ExtremeLimit& limit : map.limits) {
        reports::Column x{map.x.key, map.x.unit, {}}, y{map.y.key, map.y.unit, {}};
        reports::Column to_x{"to " + map.x.key, map.x.unit, {}},
            to_y{"to " + map.y.key, map.y.unit, {}};
        for (const Segment& s : trace(map, limit)) {
            x.values.push_back(s.x1);
            y.values.push_back(s.y1);
            to_x.values.push_back(s.x2);
            to_y.values.push_back(s.y2);
        }
        if (x.values.empty()) continue;
        ++drawn;
        figure.table(fmt::format("limit_{}_{}", map.name, drawn), {x, y, to_x, to_y})
            .set(fmt::format("limit_{}_{}", map.name, drawn), limit.title);
    }
    figure.set("limits_" + map.name, drawn);
}

void add_axis(reports::Figure& figure, const ExtremeMap& map, const std::string& side,
              const ExtremeAxis& axis) {
    const auto set = [&](const std::string& what, const auto& value) {
        figure.set(side + what + "_" + map.name, value);
    };
    set("label", axis.label);
    set("log", axis.is_logarithmic && axis.words.empty() ? 1.0 : 0.0);
    set("from", value_at(axis, first_place(axis)));
    set("to", value_at(axis, last_place(axis)));
    std::string tics;
    for (size_t k = 0; k < axis.words.size(); ++k)
        tics += fmt::format("{}\"{}\" {}", k == 0 ? "" : ", ", axis.words[k], axis.values[k]);
    set("tics", tics);
}

void add_panel(reports::Figure& figure, const ExtremeMap& map, const Points& points) {
    reports::Column x{map.x.key, map.x.unit, {}}, y{map.y.key, map.y.unit, {}},
        standing{"mark", "-", {}}, error{"error", "-", {}};
    for (const JudgedPoint& judged : points) {
        x.values.push_back(judged.point.x);
        y.values.push_back(judged.point.y);
        standing.values.push_back(mark(judged));
        error.values.push_back(judged.error);
    }
    figure.table("points_" + map.name, {x, y, standing, error})
        .set("title_" + map.name, map.title)
        .set("agree_" + map.name,
             map.limits.empty() ? "no limit from theory" : Agreement(map, points).text());
    add_axis(figure, map, "x", map.x);
    add_axis(figure, map, "y", map.y);
    add_limits(figure, map);
    figure.panel(map.name, reports::Format::svg, {.width = 760, .height = 480});
}

void list(Outcome& outcome, const std::string& what, const Points& points,
          bool (*is_meant)(const JudgedPoint&)) {
    for (const JudgedPoint& judged : points)
        if (is_meant(judged))
            outcome.findings.push_back(
                {what + ": " + judged.point.setting().text(), 100.0 * judged.error, "%"});
}

void find(Outcome& outcome, const std::vector<ExtremeMap>& maps,
          const std::vector<Points>& points) {
    Points all;
    long agree = 0, with_theory = 0;
    for (size_t k = 0; k < maps.size(); ++k) {
        std::ranges::copy(points[k], std::back_inserter(all));
        if (maps[k].limits.empty()) continue;
        const Agreement agreement(maps[k], points[k]);
        agree += agreement.agree();
        with_theory += agreement.all();
    }
    const auto add = [&](const std::string& what, auto value) {
        outcome.findings.push_back({what, double(value), "-"});
    };
    add("points", all.size());
    for (const Standing s :
         {Standing::right, Standing::remarked, Standing::refused, Standing::wrong})
        add(name(s), count(all, s));
    add("refused though right", std::ranges::count(all, true, &JudgedPoint::needlessly));
    add("advice that does not help", std::ranges::count(all, true, &JudgedPoint::misled));
    add("points on maps with a limit from theory", with_theory);
    add("of these, theory and outcome agree", agree);
    list(outcome, "wrong without a word", all,
         [](const JudgedPoint& j) { return j.standing == Standing::wrong; });
    list(outcome, "refused though right", all, [](const JudgedPoint& j) { return j.needlessly; });
    list(outcome, "advice does not help", all, [](const JudgedPoint& j) { return j.misled; });
}

std::string json_of(const std::vector<Points>& points) {
    nlohmann::ordered_json json;
    auto& all = json["points"] = nlohmann::ordered_json::array();
    for (const Points& some : points)
        for (const JudgedPoint& judged : some) all.push_back(crawford::json_of(judged));
    return json.dump(1) + '\n';
}

Outcome extremes(const Request& request) {
    const std::vector<ExtremeMap> maps = all_maps();
    const auto store = records_of_points(request.out);
    reports::Figure figure("extremes", request.out);
    std::vector<Points> points;
    std::string names;
    for (const ExtremeMap& map : maps) {
        points.push_back(judged(map, request.fidelity, *store));
        add_panel(figure, map, points.back());
        names += (names.empty() ? "" : " ") + map.name;
    }
    figure.set("maps", names)
        .other("json", "../extremes.json", json_of(points))
        .caption({.revision = revision(), .note = "each point against a much finer burn"});
    Outcome outcome{figure, {}, {}};
    find(outcome, maps, points);
    return outcome;
}

/// What a map takes on one core [s], roughly.
double seconds(const ExtremeMap& map, size_t points) {
    constexpr double slab = 0.4, plane = 2.5;
    return double(points) * (map.base.domain.nx == 1 ? slab : plane);
}

/// One job a map.
std::vector<Job> jobs(Fidelity fidelity, const std::filesystem::path& out) {
    const auto store = records_of_points(out);
    std::vector<Job> jobs;
    for (const ExtremeMap& map : all_maps()) {
        const bool is_draft = fidelity == Fidelity::draft;
        jobs.push_back({"extremes, " + map.title, seconds(map, points_of(map, is_draft).size()),
                        [map, is_draft, store](const Job::Progress& progress) {
                            const auto points = points_of(map, is_draft);
                            for (size_t k = 0; k < points.size(); ++k) {
                                judged(points[k], *store);
                                progress(double(k + 1) / double(points.size()));
                            }
                        }});
    }
    return jobs;
}

const Registered here{
    {.name = "extremes",
     .figure = "-",
     .shows = "where answers stand at the extremes, and whether the program knows",
     .physics = {physics::heat, physics::burning, physics::coupling, physics::materials,
                 physics::grid, physics::time, physics::slab, physics::sandwich, physics::pack},
     .cost = {.draft = 120.0, .paper = 900.0},
     .draw = extremes,
     .jobs = jobs}};

}  // namespace

}  // namespace crawford
