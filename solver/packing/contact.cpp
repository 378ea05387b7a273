#include "solver/packing/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crawford {

double time_to_contact(const Approach& a) {
    // The squared gap is A t^2 + 2 B t + C; wanted is its first root with a falling gap. Each root
    // is taken in the form that subtracts no nearly equal numbers.
    constexpr double never = std::numeric_limits<double>::infinity();
    const double A = a.u * a.u + a.v * a.v - a.growth * a.growth;
    const double B = a.x * a.u + a.y * a.v - a.reach * a.growth;
    const double C = std::max(0.0, a.x * a.x + a.y * a.y - a.reach * a.reach);
    if (B >= 0.0 && A >= 0.0) return never;
    const double discriminant = B * B - A * C;
    if (discriminant < 0.0) return never;
    const double root = std::sqrt(discriminant);
    return B < 0.0 ? C / (root - B) : -(B + root) / A;
}

double impulse(const Approach& a, double mass, double other_mass) {
    const double distance = std::sqrt(a.x * a.x + a.y * a.y);
    const double normal_velocity = (a.x * a.u + a.y * a.v) / distance;
    const double reduced_mass = mass * other_mass / (mass + other_mass);
    return 2.0 * reduced_mass * (a.growth - normal_velocity);
}

}  // namespace crawford
