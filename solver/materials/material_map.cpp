#include "solver/materials/material_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/materials/disc_overlap.hpp"
#include "solver/materials/interface_normal.hpp"
#include "solver/materials/strip_overlap.hpp"

namespace crawford {

namespace {

double arithmetic(double fraction, double first, double second) {
    return fraction * first + (1.0 - fraction) * second;
}

double harmonic(double fraction, double first, double second) {
    return 1.0 / (fraction / first + (1.0 - fraction) / second);
}

bool is_cut(double fraction) {
    return fraction != 0.0 && fraction != 1.0;
}

/// A cell that is full or empty but for round-off is full or empty.
double snapped(double fraction) {
    constexpr double round_off = 1e-9;
    const double whole = std::round(fraction);
    return std::abs(fraction - whole) < round_off ? whole : fraction;
}

}  // namespace

MaterialMap::MaterialMap(Morphology morphology, const Grid& grid, const Numerics& numerics)
    : grid_(grid),
      morphology_(std::move(morphology)),
      conductivity_(numerics.cut_cell_conductivity),
      moduli_(numerics.cut_cell_moduli),
      front_(numerics.front),
      fraction_(grid.cell_columns(), grid.rows(), 1.0),
      bulk_modulus_(grid.cell_columns(), grid.rows()),
      shear_modulus_(grid.cell_columns(), grid.rows()) {
    follow(SurfaceField(size_t(grid.node_columns()), 0.0));
}

bool MaterialMap::moves() const {
    return std::holds_alternative<Discs>(morphology_.shape) ||
           (std::holds_alternative<Sandwich>(morphology_.shape) && is_carried());
}

void MaterialMap::follow(const SurfaceField& surface, const NodeVectors& shift) {
    const bool carried = is_carried() && !shift.empty();
    const CarriedGrid where(grid_, surface, carried ? &shift : nullptr);
    if (const auto* sandwich = std::get_if<Sandwich>(&morphology_.shape)) {
        if (carried)
            fill_carried_strip(sandwich->strip, where);
        else
            fill_strip(sandwich->strip);
    }
    if (const auto* discs = std::get_if<Discs>(&morphology_.shape)) fill_discs(*discs, where);
    for (double& fraction : fraction_.values()) fraction = snapped(fraction);
    find_surface_pieces(where);
    find_moduli();
    if (is_laminate()) find_normals(surface);
}

void MaterialMap::find_moduli() {
    for (size_t k = 0; k < fraction_.values().size(); ++k) {
        const double fraction = fraction_.values()[k];
        bulk_modulus_.values()[k] = modulus(fraction, &Material::bulk_modulus);
        shear_modulus_.values()[k] = modulus(fraction, &Material::shear_modulus);
    }
}

double MaterialMap::period() const {
    return (grid_.sides() == Sides::mirror ? 2.0 : 1.0) * grid_.width();
}

void MaterialMap::find_normals(const SurfaceField& surface) {
    normal_ = Lattice<Vector>(grid_.cell_columns(), grid_.rows());
    for (int i = 0; i < grid_.cell_columns(); ++i)
        for (int j = 0; j < grid_.rows(); ++j)
            if (is_cut(fraction_(i, j)))
                normal_(i, j) = interface_normal(grid_, surface, fraction_, i, j);
}

void MaterialMap::fill_strip(double width) {
    for (int i = 0; i < grid_.cell_columns(); ++i) {
        const double left = std::max(grid_.x(i), -0.5 * width);
        const double right = std::min(grid_.x(i) + grid_.dx(i), 0.5 * width);
        const double covered = std::max(right - left, 0.0) / grid_.dx(i);
        for (int j = 0; j < grid_.rows(); ++j) fraction_(i, j) = 1.0 - covered;
    }
}

/// Strips stand side by side, a period apart: cells near a side may have come from beyond it.
void MaterialMap::fill_carried_strip(double width, const CarriedGrid& carried) {
    for (int i = 0; i < grid_.cell_columns(); ++i)
        for (int j = 0; j < grid_.rows(); ++j) {
            double covered = 0.0;
            for (const int image : {-1, 0, 1})
                covered += strip_overlap(carried.cell(i, j, {image * period(), 0.0}), 0.5 * width);
            fraction_(i, j) = 1.0 - covered / carried.area(i, j);
        }
}

/// Calls visit(centre, radius) for every disc, and every periodic image of it, that may reach into
/// the box from `low` to `high`.
template <class Visit>
void MaterialMap::for_discs_in(const Discs& discs, const Vector& low, const Vector& high,
                               const Visit& visit) const {
    const double width = grid_.width();
    for (const Disc& disc : discs.discs) {
        const int first_y = int(std::ceil((low.y() - disc.radius - disc.y) / discs.period));
        const int last_y = int(std::floor((high.y() + disc.radius - disc.y) / discs.period));
        const int first_x = int(std::ceil((low.x() - disc.radius - disc.x) / width));
        const int last_x = int(std::floor((high.x() + disc.radius - disc.x) / width));
        for (int m = first_x; m <= last_x; ++m)
            for (int n = first_y; n <= last_y; ++n)
                visit(Vector(disc.x + m * width, disc.y + n * discs.period), disc.radius);
    }
}

void MaterialMap::fill_discs(const Discs& discs, const CarriedGrid& carried) {
    std::ranges::fill(fraction_.values(), 0.0);
    for_discs_in(discs, carried.lowest(), carried.highest(),
                 [&](const Vector& centre, double radius) { add_disc(centre, radius, carried); });
}

void MaterialMap::add_disc(Vector centre, double radius, const CarriedGrid& carried) {
    const auto [first, last] = carried.columns(centre.x() - radius, centre.x() + radius);
    for (int i = first; i < last; ++i) {
        const auto [lowest, highest] = carried.rows(i, centre.y() - radius, centre.y() + radius);
        for (int j = lowest; j < highest; ++j) {
            const auto cell = carried.cell(i, j, centre);
            const auto [low, high] =
                std::minmax({cell[0].y(), cell[1].y(), cell[2].y(), cell[3].y()});
            if (low > radius || high < -radius) continue;
            fraction_(i, j) += disc_overlap(cell, radius) / carried.area(i, j);
        }
    }
}

void MaterialMap::find_surface_pieces(const CarriedGrid& carried) {
    surface_pieces_.resize(size_t(grid_.cell_columns()));
    for (int i = 0; i < grid_.cell_columns(); ++i)
        surface_pieces_[size_t(i)] = front_ == Front::mean_of_materials
                                         ? SegmentPieces{{0.0, 1.0, fraction_(i, grid_.rows() - 1)}}
                                         : pieces_by_interfaces(i, carried);
}

SegmentPieces MaterialMap::pieces_by_interfaces(int i, const CarriedGrid& carried) const {
    std::vector<Covered> covered;
    if (const auto* sandwich = std::get_if<Sandwich>(&morphology_.shape)) {
        for (const int image : {-1, 0, 1})
            if (const auto part = covered_by_strip(carried.top(i, {image * period(), 0.0}),
                                                   0.5 * sandwich->strip))
                covered.push_back(*part);
        return pieces_of(std::move(covered), 0.0,
                         {second().thermal_conductivity, first().thermal_conductivity});
    }
    if (const auto* discs = std::get_if<Discs>(&morphology_.shape)) {
        const Segment top = carried.top(i, Vector::Zero());
        for_discs_in(*discs, top[0].cwiseMin(top[1]), top[0].cwiseMax(top[1]),
                     [&](const Vector& centre, double radius) {
                         if (const auto part = covered_by_disc(carried.top(i, centre), radius))
                             covered.push_back(*part);
                     });
        return pieces_of(std::move(covered), 1.0,
                         {first().thermal_conductivity, second().thermal_conductivity});
    }
    return {{0.0, 1.0, 1.0}};
}

double MaterialMap::thermal_conductivity(int i, int j) const {
    const auto mean = conductivity_ == CutConductivity::harmonic ? harmonic : arithmetic;
    return mean(fraction_(i, j), first().thermal_conductivity, second().thermal_conductivity);
}

Eigen::Matrix2d MaterialMap::further_conductivity(int i, int j) const {
    if (!is_laminate() || !is_cut(fraction_(i, j))) return Eigen::Matrix2d::Zero();
    const double across =
        harmonic(fraction_(i, j), first().thermal_conductivity, second().thermal_conductivity);
    const Vector& normal = normal_(i, j);
    return (across - thermal_conductivity(i, j)) * normal * normal.transpose();
}

double MaterialMap::density(int i, int j) const {
    return arithmetic(fraction_(i, j), first().density, second().density);
}

double MaterialMap::heat_capacity(int i, int j) const {
    return arithmetic(fraction_(i, j), first().density * first().specific_heat,
                      second().density * second().specific_heat);
}

double MaterialMap::modulus(double fraction, double Material::*property) const {
    const auto mean = moduli_ == CutModuli::harmonic ? harmonic : arithmetic;
    return mean(fraction, first().*property, second().*property);
}

double MaterialMap::thermal_expansion(int i, int j) const {
    return arithmetic(fraction_(i, j), first().thermal_expansion, second().thermal_expansion);
}

double MaterialMap::thermal_stress(int i, int j, ThermalStress reading) const {
    const double factor = reading == ThermalStress::three_alpha_bulk ? 3.0 : 1.0;
    return factor * thermal_expansion(i, j) * bulk_modulus(i, j);
}

}  // namespace crawford
