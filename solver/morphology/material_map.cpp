#include "solver/morphology/material_map.hpp"

#include <algorithm>
#include <cmath>

#include "solver/morphology/disc_overlap.hpp"

namespace crawford {

namespace {

double arithmetic(double fraction, double first, double second) {
    return fraction * first + (1.0 - fraction) * second;
}

double harmonic(double fraction, double first, double second) {
    return 1.0 / (fraction / first + (1.0 - fraction) / second);
}

/// A cell that is full or empty but for round-off is full or empty.
double snapped(double fraction) {
    constexpr double round_off = 1e-9;
    const double whole = std::round(fraction);
    return std::abs(fraction - whole) < round_off ? whole : fraction;
}

}  // namespace

MaterialMap::MaterialMap(const Morphology& morphology, const Grid& grid)
    : grid_(grid),
      shape_(morphology.shape),
      materials_(morphology.materials),
      fraction_(grid.cell_columns(), grid.rows(), 1.0) {
    follow(SurfaceField(size_t(grid.node_columns()), 0.0));
}

bool MaterialMap::moves() const {
    return std::holds_alternative<Discs>(shape_);
}

void MaterialMap::follow(const SurfaceField& surface) {
    if (const auto* sandwich = std::get_if<Sandwich>(&shape_)) fill_strip(sandwich->strip);
    if (const auto* discs = std::get_if<Discs>(&shape_)) fill_discs(*discs, surface);
    for (double& fraction : fraction_.values()) fraction = snapped(fraction);
}

void MaterialMap::fill_strip(double width) {
    for (int i = 0; i < grid_.cell_columns(); ++i) {
        const double left = std::max(grid_.x(i), -0.5 * width);
        const double right = std::min(grid_.x(i) + grid_.dx(), 0.5 * width);
        const double covered = std::max(right - left, 0.0) / grid_.dx();
        for (int j = 0; j < grid_.rows(); ++j) fraction_(i, j) = 1.0 - covered;
    }
}

void MaterialMap::fill_discs(const Discs& discs, const SurfaceField& surface) {
    std::ranges::fill(fraction_.values(), 0.0);
    const auto [low, high] = std::ranges::minmax(surface);
    const double bottom = low - grid_.depth();
    const double width = grid_.width();
    const double left = grid_.x(0);
    for (const Disc& disc : discs.discs) {
        const int first_y = int(std::ceil((bottom - disc.radius - disc.y) / discs.period));
        const int last_y = int(std::floor((high + disc.radius - disc.y) / discs.period));
        const int first_x = int(std::ceil((left - disc.radius - disc.x) / width));
        const int last_x = int(std::floor((left + width + disc.radius - disc.x) / width));
        for (int m = first_x; m <= last_x; ++m)
            for (int n = first_y; n <= last_y; ++n)
                add_disc({disc.x + m * width, disc.y + n * discs.period}, disc.radius, surface);
    }
}

void MaterialMap::add_disc(Vector centre, double radius, const SurfaceField& surface) {
    const double dx = grid_.dx();
    const int first = std::max(int(std::floor((centre.x() - radius - grid_.x(0)) / dx)), 0);
    const int last =
        std::min(int(std::ceil((centre.x() + radius - grid_.x(0)) / dx)), grid_.cell_columns());
    for (int i = first; i < last; ++i) {
        const double y_left = surface[size_t(i)] - centre.y();
        const double y_right = surface[size_t(grid_.right_node(i))] - centre.y();
        const double x_left = grid_.x(i) - centre.x();
        for (int j = 0; j < grid_.rows(); ++j) {
            const double low = grid_.eta(j);
            const double high = grid_.eta(j + 1);
            if (std::min(y_left, y_right) + low > radius ||
                std::max(y_left, y_right) + high < -radius)
                continue;
            const std::array<Vector, 4> cell{{{x_left, y_left + low},
                                              {x_left + dx, y_right + low},
                                              {x_left + dx, y_right + high},
                                              {x_left, y_left + high}}};
            fraction_(i, j) += disc_overlap(cell, radius) / (dx * (high - low));
        }
    }
}

double MaterialMap::thermal_conductivity(int i, int j) const {
    return arithmetic(fraction_(i, j), first().thermal_conductivity, second().thermal_conductivity);
}

double MaterialMap::density(int i, int j) const {
    return arithmetic(fraction_(i, j), first().density, second().density);
}

double MaterialMap::heat_capacity(int i, int j) const {
    return arithmetic(fraction_(i, j), first().density * first().specific_heat,
                      second().density * second().specific_heat);
}

double MaterialMap::bulk_modulus(int i, int j) const {
    return harmonic(fraction_(i, j), first().bulk_modulus, second().bulk_modulus);
}

double MaterialMap::shear_modulus(int i, int j) const {
    return harmonic(fraction_(i, j), first().shear_modulus, second().shear_modulus);
}

double MaterialMap::thermal_expansion(int i, int j) const {
    return arithmetic(fraction_(i, j), first().thermal_expansion, second().thermal_expansion);
}

double MaterialMap::thermal_stress(int i, int j, ThermalStress reading) const {
    const double factor = reading == ThermalStress::three_alpha_bulk ? 3.0 : 1.0;
    return factor * thermal_expansion(i, j) * bulk_modulus(i, j);
}

}  // namespace crawford
