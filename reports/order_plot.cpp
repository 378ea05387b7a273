#include "reports/order_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "base/scratch.hpp"
#include "reports/convergence_figure.hpp"

namespace crawford::reports {
namespace {

/// No script can hold a control character.
std::string printable(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, '?');
    return text;
}

ConvergenceCurve curve(const OrderTable& table, const JudgedColumn& column) {
    const auto& values = column.values();
    std::vector<Level> levels;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (column.is_error)
            levels.push_back({table.grids[i], table.h[i], values[i]});
        else if (i + 1 < values.size())
            levels.push_back({table.grids[i], table.h[i], std::abs(values[i] - values[i + 1])});
    }
    return {.label = printable(column.result.quantity) +
                     (column.is_error ? "" : ", change to the next grid"),
            .convergence = Convergence(levels),
            .expected = column.result.expected};
}

bool has_point(const ConvergenceCurve& curve) {
    return std::ranges::any_of(curve.convergence.levels(),
                               [](const Level& level) { return level.error > 0.0; });
}

std::string content(const std::filesystem::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string picture(const OrderTable& table, const std::vector<ConvergenceCurve>& curves) {
    const Scratch scratch;
    return content(
        draw_convergence("order", scratch.path(), printable(table.name), curves, {},
                         {.h = table.counts_cells() ? "cell size h" : printable(table.size_name),
                          .error = "error"}));
}

}  // namespace

void draw_orders(const std::filesystem::path& file, const OrderTable& table,
                 const std::vector<JudgedColumn>& columns) {
    if (file.extension() != ".svg")
        throw InputError(
            fmt::format("--plot {}: the picture is an SVG; give it a name that ends "
                        "in .svg",
                        file.string()));
    std::vector<ConvergenceCurve> curves;
    for (const JudgedColumn& column : columns)
        if (auto one = curve(table, column); has_point(one)) curves.push_back(std::move(one));
    if (curves.empty())
        throw InputError(
            fmt::format("--plot {}: {} has no error above zero and no values that "
                        "differ: nothing to draw",
                        file.string(), table.name));
    write_file(file, picture(table, curves));
}

}  // namespace crawford::reports
