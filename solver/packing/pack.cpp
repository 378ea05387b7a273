#include "solver/packing/pack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/errors.hpp"
#include "solver/packing/hard_discs.hpp"
#include "solver/packing/random.hpp"

namespace crawford {

namespace {

// The discs grow and move in units in which their mean radius is 1, gap included, and each carries
// on average the kinetic energy 1.

/// Rate of growth: about how much slower the rims move than the discs. Slower packs denser and
/// takes longer; docs/packs.md has the numbers.
constexpr double growth = 0.01;
/// Collisions a disc between two settings of the energy, which growth feeds.
constexpr long between_settings = 10;
/// Discs that grow, relatively, by less than `standstill` in so many collisions a disc have jammed.
constexpr long patience = 1000;
constexpr double standstill = 1e-6;
/// Without growth at the end: collisions a disc, or the time of flight over so many radii.
constexpr long forgetting = 100;
/// The discs that move are larger by this than asked, so that round-off never costs a gap.
constexpr double allowance = 1e-9;

constexpr double micrometre = 1e-6;  // [m]

/// The nearest whole number of attometres. A conversion of units may err in the last bit, and that
/// bit would make another pack.
double free_of_round_off(double length) {
    constexpr double attometres = 1e18;  // in a metre
    return std::round(length * attometres) / attometres;
}

PackRecipe free_of_round_off(PackRecipe recipe) {
    recipe.width = free_of_round_off(recipe.width);
    recipe.smallest_gap = free_of_round_off(recipe.smallest_gap);
    for (DiscSize& size : recipe.discs) size.radius = free_of_round_off(size.radius);
    return recipe;
}

std::vector<double> radii(const PackRecipe& recipe) {
    std::vector<double> radii;
    for (const DiscSize& size : recipe.discs)
        radii.insert(radii.end(), static_cast<std::size_t>(size.count), size.radius);
    return radii;
}

double area_of(const std::vector<double>& radii) {
    double area = 0.0;
    for (const double radius : radii) area += std::numbers::pi * radius * radius;
    return area;
}

void check_fit(const PackRecipe& recipe) {
    const double room = std::min(recipe.width, period(recipe));
    for (const DiscSize& size : recipe.discs) {
        const double needed = 2.0 * size.radius + recipe.smallest_gap;
        if (needed * (1.0 + allowance) < room) continue;
        throw InputError(fmt::format(
            "discs of radius {:.6g} um and a gap need {:.6g} um, and the box is {:.6g} um x {:.6g} "
            "um; take more discs, a lower area fraction, or another width",
            size.radius / micrometre, needed / micrometre, recipe.width / micrometre,
            period(recipe) / micrometre));
    }
}

/// The unit of length of the motion [m].
double mean_radius(const std::vector<double>& radii, double gap) {
    double sum = 0.0;
    for (const double radius : radii) sum += radius + 0.5 * gap;
    return sum / static_cast<double>(radii.size());
}

/// Points that will be discs, at random in the box, without momentum.
std::vector<HardDisc> points(const PackRecipe& recipe, const Box& box, double unit) {
    Random random(recipe.seed);
    std::vector<HardDisc> points;
    double momentum_x = 0.0;
    double momentum_y = 0.0;
    for (const double given : radii(recipe)) {
        const double radius = (given + 0.5 * recipe.smallest_gap) * (1.0 + allowance) / unit;
        // a braced list is evaluated from left to right
        const HardDisc p{.x = box.width * random.unit(),
                         .y = box.height * random.unit(),
                         .u = 2.0 * random.unit() - 1.0,
                         .v = 2.0 * random.unit() - 1.0,
                         .radius = radius,
                         .mass = radius * radius};
        momentum_x += p.mass * p.u;
        momentum_y += p.mass * p.v;
        points.push_back(p);
    }
    for (HardDisc& p : points) {
        p.u -= momentum_x / (p.mass * static_cast<double>(points.size()));
        p.v -= momentum_y / (p.mass * static_cast<double>(points.size()));
    }
    return points;
}

[[noreturn]] void refuse_jammed(const PackRecipe& recipe, double size) {
    throw InputError(fmt::format(
        "the discs have jammed at an area fraction of {:.4f}, short of {:.4f}, with gaps of {:.4g} "
        "um; ask for less, a smaller gap or a wider mix of radii, or try another seed",
        recipe.area_fraction * size * size, recipe.area_fraction,
        recipe.smallest_gap / micrometre));
}

void grow(HardDiscs& discs, const PackRecipe& recipe) {
    const auto count = static_cast<long>(discs.discs().size());
    double mark = 0.0;
    long collisions = 0;
    while (discs.size() < 1.0) {
        discs.set_energy(static_cast<double>(count));
        collisions +=
            discs.advance(growth, (1.0 - discs.size()) / growth, between_settings * count);
        if (collisions < patience * count) continue;
        if (discs.size() < mark * (1.0 + standstill)) refuse_jammed(recipe, discs.size());
        mark = discs.size();
        collisions = 0;
    }
}

/// Moves on without growth, and a little beyond the last collision, so as not to stop at a touch.
void forget(HardDiscs& discs) {
    const auto count = static_cast<long>(discs.discs().size());
    discs.set_energy(static_cast<double>(count));
    discs.advance(0.0, forgetting, forgetting * count);
    discs.advance(0.0, 1.0);
}

double wrapped(double x, double least, double period) {
    return x - period * std::floor((x - least) / period);
}

}  // namespace

double period(const PackRecipe& recipe) {
    return area_of(radii(recipe)) / (recipe.area_fraction * recipe.width);
}

Discs random_pack(const PackRecipe& asked) {
    const PackRecipe recipe = free_of_round_off(asked);
    check_fit(recipe);
    const std::vector<double> given = radii(recipe);
    const double unit = mean_radius(given, recipe.smallest_gap);
    const Box box{.width = recipe.width / unit, .height = period(recipe) / unit};
    HardDiscs moving(box, points(recipe, box, unit), 0.0);
    grow(moving, recipe);
    forget(moving);

    Discs pack{.discs = {}, .period = period(recipe)};
    for (std::size_t i = 0; i < given.size(); ++i) {
        const HardDisc& disc = moving.discs()[i];
        pack.discs.push_back({.x = wrapped(disc.x * unit, -0.5 * recipe.width, recipe.width),
                              .y = -wrapped(disc.y * unit, 0.0, pack.period),
                              .radius = given[i]});
    }
    return pack;
}

double smallest_gap(const Discs& pack, double width) {
    double least = std::numeric_limits<double>::infinity();
    const auto& discs = pack.discs;
    for (std::size_t i = 0; i < discs.size(); ++i) {
        least = std::min(least, std::min(width, pack.period) - 2.0 * discs[i].radius);
        for (std::size_t j = i + 1; j < discs.size(); ++j) {
            const double x = std::remainder(discs[i].x - discs[j].x, width);
            const double y = std::remainder(discs[i].y - discs[j].y, pack.period);
            least = std::min(least, std::hypot(x, y) - discs[i].radius - discs[j].radius);
        }
    }
    return least;
}

double area_fraction(const Discs& pack, double width) {
    std::vector<double> radii;
    for (const Disc& disc : pack.discs) radii.push_back(disc.radius);
    return area_of(radii) / (width * pack.period);
}

}  // namespace crawford
