/// A stress that a prescribed motion without spin carries, and how well the solver's rate of it
/// agrees with the exact one.
#pragma once

#include "cases/verify/comparison.hpp"
#include "cases/verify/prescribed_motion.hpp"
#include "reference/carried_profile.hpp"

namespace crawford {

/// A profile for each component of the stress, of one shape but out of step with each other: s12 is
/// odd in x where the others are even, as symmetry wants it.
class CarriedStress {
public:
    explicit CarriedStress(const reference::ProfileShape& shape);

    Deviator deviator(const Vector& x) const;
    double pressure(const Vector& x) const { return pressure_.value(x); }
    /// What a point of the grid that moves with `point` sees, per second.
    Deviator deviator_rate(const Vector& x, const Vector& material, const Vector& point) const;
    double pressure_rate(const Vector& x, const Vector& material, const Vector& point) const;

    /// On every point and cell of a grid.
    StressField on(const PrescribedMotion& body) const;

private:
    reference::CarriedProfile s11_, s22_, s12_, pressure_;
};

/// The rates (sigma* - sigma)/dt of one step of `predict`, which are free of any error in time.
class StressRates {
public:
    StressRates(const PrescribedMotion& body, const CarriedStress& truth, const Motion& motion);

    /// At each point that carries a deviator.
    Comparison at_points() const;
    /// Of the mean over the points of each cell.
    Comparison mean_of_cells() const;
    Comparison pressure() const;

    /// Largest |rate| of s11 in the first row [Pa/s], which the others leave out: stress enters
    /// with zero gradient there, whatever the profile.
    double fastest_in_first_row() const;

private:
    bool is_compared(const CellPoint& at) const { return at.j > 0 || body_.grid().rows() == 1; }
    Deviator found(const CellPoint& at) const;
    Deviator exact(const CellPoint& at) const;

    const PrescribedMotion& body_;
    const CarriedStress& truth_;
    std::function<Vector(Vector)> material_;
    double dt_;
    StressField before_, after_;
};

/// What measure_rates reports: errors, and one number.
namespace carried {
inline constexpr auto points = "deviator at its points";
inline constexpr auto mean = "deviator, mean of a cell";
inline constexpr auto pressure = "pressure";
inline constexpr auto first_row = "fastest change in the first row [Pa/s]";
}  // namespace carried

/// A profile, the motion that carries it and the grid on which.
struct CarriedSetup {
    std::function<Domain(int cells)> domain;
    Motion motion;
    reference::ProfileShape profile;
    Element element = Element::bbar;
};

/// The errors of the rates of one step, on `cells` cells.
reports::Measurement measure_rates(const CarriedSetup& setup, int cells);

}  // namespace crawford
