#include "reports/page/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/page/words.hpp"

namespace crawford::reports::page {
namespace {

constexpr double width = 270.0, height = 190.0;
constexpr double left = 48.0, right = 12.0, top = 24.0, bottom = 38.0;

std::string px(double value) {
    return fmt::format("{:.1f}", value);
}

Html line(double x1, double y1, double x2, double y2, const std::string& style) {
    return element(
        "line", {{"x1", px(x1)}, {"y1", px(y1)}, {"x2", px(x2)}, {"y2", px(y2)}, {"class", style}});
}

Html words(double x, double y, const std::string& anchor, const std::string& text) {
    return element("text", {{"x", px(x)}, {"y", px(y)}, {"text-anchor", anchor}}, text);
}

Html dot(double x, double y, const std::string& style) {
    return element("circle", {{"cx", px(x)}, {"cy", px(y)}, {"r", "3.2"}, {"class", style}});
}

Html svg(double w, double h, const std::string& label, const Html& content) {
    return element("svg",
                   {{"viewBox", fmt::format("0 0 {:g} {:g}", w, h)},
                    {"width", fmt::format("{:g}", w)},
                    {"height", fmt::format("{:g}", h)},
                    {"role", "img"},
                    {"aria-label", label}},
                   content);
}

/// A logarithmic axis between two numbers, on the screen from `from` to `to`.
struct Axis {
    double low, high, from, to;

    double operator()(double value) const {
        return from + (std::log10(value) - low) / (high - low) * (to - from);
    }
};

/// The axis that holds all values, with room for a tenth at either end and at least a decade.
Axis axis_of(const std::vector<double>& values, double from, double to, double least) {
    const auto [low, high] = std::ranges::minmax(values);
    double a = std::log10(low), b = std::log10(high);
    const double room = std::max(0.1 * (b - a), 0.5 * (least - (b - a)));
    return {a - room, b + room, from, to};
}

struct Point {
    int grid;
    double h, error;
    bool fitted;
};

std::vector<Point> drawable(const GateResult& gate) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < gate.grids.size() && i < gate.errors.size(); ++i)
        if (gate.errors[i] > 0.0 && std::isfinite(gate.errors[i]) && gate.h[i] > 0.0)
            points.push_back({gate.grids[i], gate.h[i], gate.errors[i],
                              gate.grids[i] >= gate.coarsest && gate.grids[i] <= gate.finest});
    return points;
}

/// Powers of ten, as many as there is room for.
Html error_ticks(const Axis& y) {
    const int first = int(std::ceil(y.low)), last = int(std::floor(y.high));
    const int step = std::max(1, (last - first + 1) / 4);
    Html html;
    for (int power = first; power <= last; power += step) {
        const double at = y(std::pow(10.0, power));
        html += line(left, at, width - right, at, "grid");
        html += words(left - 5.0, at + 3.5, "end", fmt::format("1e{}", power));
    }
    return html;
}

Html grid_ticks(const std::vector<Point>& points, const Axis& x) {
    Html html;
    double last = 0.0;
    for (const auto& point : std::vector(points.rbegin(), points.rend())) {
        const double at = x(point.h);
        html += line(at, height - bottom, at, height - bottom + 4.0, "axis");
        if (at - last < 24.0) continue;  // no room for another number
        last = at;
        html += words(at, height - bottom + 15.0, "middle", std::to_string(point.grid));
    }
    return html;
}

/// The expected slope through the finest fitted point, over all grids.
Html expected_slope(const GateResult& gate, const std::vector<Point>& points, const Axis& x,
                    const Axis& y) {
    const auto anchor = std::ranges::find_if(points.rbegin(), points.rend(), &Point::fitted);
    if (anchor == points.rend() || std::isnan(gate.expected)) return {};
    const auto at = [&](double h) {
        return anchor->error * std::pow(h / anchor->h, gate.expected);
    };
    const double h1 = points.front().h, h2 = points.back().h;
    return line(x(h1), y(at(h1)), x(h2), y(at(h2)), "expected");
}

}  // namespace

Html order_plot(const GateResult& gate) {
    const auto points = drawable(gate);
    if (points.empty()) return {};
    std::vector<double> h, errors;
    for (const auto& point : points) {
        h.push_back(point.h);
        errors.push_back(point.error);
    }
    const auto x = axis_of(h, left, width - right, 0.5);
    const auto y = axis_of(errors, height - bottom, top, 1.3);

    std::string path;
    Html dots;
    for (const auto& point : points) {
        path += px(x(point.h)) + ',' + px(y(point.error)) + ' ';
        dots += dot(x(point.h), y(point.error), point.fitted ? "measured" : "measured hollow");
    }
    Html content = error_ticks(y) + grid_ticks(points, x);
    content += line(left, top, left, height - bottom, "axis");
    content += line(left, height - bottom, width - right, height - bottom, "axis");
    content +=
        words(0.5 * (left + width - right), height - 4.0, "middle", "grid (finer to the left)");
    content += words(4.0, 13.0, "start", "error");
    content += expected_slope(gate, points, x, y);
    if (!std::isnan(gate.expected))
        content += words(width - right, 13.0, "end",
                         fmt::format("dashed: order {:g}, as expected", gate.expected));
    content += element("polyline", {{"points", path}, {"class", "measured"}}) + dots;
    return svg(width, height, "error against cell size, " + title(gate), content);
}

Html bound_plot(const GateResult& gate) {
    if (!std::isfinite(gate.value)) return {};
    constexpr double tall = 54.0, at = 22.0;
    std::vector<double> ends{gate.value};
    for (const double end : {gate.low, gate.high})
        if (std::isfinite(end)) ends.push_back(end);
    auto [low, high] = std::ranges::minmax(ends);
    const double room = high > low ? 0.15 * (high - low) : std::max(1.0, std::abs(high));
    const auto x = [low = low - room, high = high + room](double value) {
        return right + std::clamp((value - low) / (high - low), 0.0, 1.0) * (width - 2.0 * right);
    };
    const double from = x(gate.low), to = x(gate.high);
    Html content = line(right, at, width - right, at, "axis");
    content += element("rect", {{"x", px(from)},
                                {"y", px(at - 5.0)},
                                {"width", px(to - from)},
                                {"height", "10"},
                                {"class", "allowed"}});
    const auto label = [&](double end, const char* anchor) {
        if (std::isfinite(end)) content += words(x(end), at + 20.0, anchor, number(end));
    };
    label(gate.low, "start");
    label(gate.high, "end");
    content += dot(x(gate.value), at, gate.passed ? "measured" : "measured outside");
    return svg(width, tall, "value within its bounds, " + title(gate), content);
}

}  // namespace crawford::reports::page
