#include "cases/explore/extreme_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "solver/guards/predicted.hpp"
#include "solver/scene/defaults.hpp"

namespace crawford {

namespace {

Scene scene_at(const ExtremeMap& map, double x, double y) {
    Scene scene = map.base;
    map.x.put(scene, x * map.x.scale);
    map.y.put(scene, y * map.y.scale);
    if (map.finish) map.finish(scene);
    return scene;
}

void set(reports::Setting& setting, const ExtremeAxis& axis, double value) {
    if (!axis.words.empty())
        setting.set(axis.key, axis.words[size_t(value)]);
    else if (axis.unit == "cells")
        setting.set(axis.key, long(value));
    else
        setting.set(axis.key, reports::Amount{value, axis.unit});
}

std::vector<double> ends(const std::vector<double>& values, bool with_middle) {
    if (values.size() < 3) return values;
    if (!with_middle) return {values.front(), values.back()};
    return {values.front(), values[values.size() / 2], values.back()};
}

/// Where the straight line between two values crosses 1, from 0 to 1; negative where it does not.
double crossing(double from, double to) {
    if (!((from > 1.0) != (to > 1.0)) || std::isnan(from) || std::isnan(to)) return -1.0;
    return (1.0 - from) / (to - from);
}

/// How a limit lies over a fine raster of the map.
class Raster {
public:
    Raster(const ExtremeMap& map, const ExtremeLimit& limit)
        : map_(map),
          columns_(map.x.words.empty() ? fine : int(map.x.values.size()) - 1),
          rows_(map.y.words.empty() ? fine : int(map.y.values.size()) - 1) {
        for (int j = 0; j <= rows_; ++j)
            for (int i = 0; i <= columns_; ++i)
                beyond_.push_back(beyond(limit, scene_at(map, x(i), y(j))));
    }

    std::vector<Segment> segments() const {
        std::vector<Segment> all;
        if (map_.y.words.empty())
            add_contour(all);
        else
            add_rows(all);
        return all;
    }

private:
    static constexpr int fine = 60;

    double x(double i) const { return along(map_.x, i, columns_); }
    double y(double j) const { return along(map_.y, j, rows_); }
    double at(int i, int j) const { return beyond_[size_t(j) * size_t(columns_ + 1) + size_t(i)]; }

    static double along(const ExtremeAxis& axis, double part, int parts) {
        if (!axis.words.empty()) return part;
        const double first = first_place(axis), last = last_place(axis);
        const double value = value_at(axis, first + (last - first) * part / parts);
        const bool can_be_negative = axis.values.front() < 0.0;
        return can_be_negative ? value : std::max(value, 0.0);
    }

    /// Marching squares.
    void add_contour(std::vector<Segment>& all) const {
        for (int j = 0; j < rows_; ++j)
            for (int i = 0; i < columns_; ++i) {
                std::vector<std::pair<double, double>> met;
                const auto add = [&](double part, double di, double dj, double i0, double j0) {
                    if (part >= 0.0) met.emplace_back(x(i0 + part * di), y(j0 + part * dj));
                };
                add(crossing(at(i, j), at(i + 1, j)), 1, 0, i, j);
                add(crossing(at(i, j), at(i, j + 1)), 0, 1, i, j);
                add(crossing(at(i + 1, j), at(i + 1, j + 1)), 0, 1, i + 1, j);
                add(crossing(at(i, j + 1), at(i + 1, j + 1)), 1, 0, i, j + 1);
                for (size_t k = 0; k + 1 < met.size(); k += 2)
                    all.push_back(
                        {met[k].first, met[k].second, met[k + 1].first, met[k + 1].second});
            }
    }

    /// Words in y have nothing between them: each has a mark of its own.
    void add_rows(std::vector<Segment>& all) const {
        constexpr double half = 0.42;
        for (int j = 0; j <= rows_; ++j)
            for (int i = 0; i < columns_; ++i) {
                const double part = crossing(at(i, j), at(i + 1, j));
                if (part >= 0.0) all.push_back({x(i + part), j - half, x(i + part), j + half});
            }
    }

    const ExtremeMap& map_;
    int columns_, rows_;
    std::vector<double> beyond_;
};

}  // namespace

Scene ExtremePoint::scene() const {
    return scene_at(*map, x, y);
}

reports::Setting ExtremePoint::setting() const {
    reports::Setting setting;
    setting.set("map", map->title);
    set(setting, map->x, x);
    set(setting, map->y, y);
    return setting;
}

std::vector<ExtremePoint> points_of(const ExtremeMap& map, bool is_draft) {
    std::vector<ExtremePoint> points;
    for (const double y : is_draft ? ends(map.y.values, false) : map.y.values)
        for (const double x : is_draft ? ends(map.x.values, true) : map.x.values)
            points.push_back({&map, x, y});
    return points;
}

double beyond(const ExtremeLimit& limit, const Scene& scene) {
    const Guards guards = predicted(resolved(scene));
    const auto guard = std::ranges::find(guards, limit.guard, &Guard::name);
    const auto at = guard == guards.end() ? std::nullopt : limit.at ? limit.at : guard->limit;
    if (!at) return std::numeric_limits<double>::quiet_NaN();
    return limit.is_least ? *at / guard->value : guard->value / *at;
}

std::vector<Segment> trace(const ExtremeMap& map, const ExtremeLimit& limit) {
    return Raster(map, limit).segments();
}

double place(const ExtremeAxis& axis, double value) {
    return axis.is_logarithmic && axis.words.empty() ? std::log10(value) : value;
}

double value_at(const ExtremeAxis& axis, double place) {
    return axis.is_logarithmic && axis.words.empty() ? std::pow(10.0, place) : place;
}

double first_place(const ExtremeAxis& axis) {
    const double first = place(axis, axis.values[0]);
    return first - 0.5 * (place(axis, axis.values[1]) - first);
}

double last_place(const ExtremeAxis& axis) {
    const double last = place(axis, axis.values.back());
    return last + 0.5 * (last - place(axis, axis.values[axis.values.size() - 2]));
}

}  // namespace crawford
