#include "reference/onset.hpp"

#include <cmath>
#include <stdexcept>

#include "reference/root.hpp"

namespace crawford::reference {

SwingingFront::SwingingFront(const SlabConditions& conditions) : front_(steady_front(conditions)) {
    const double z = front_.sensitivity;
    const double w = z * front_.reaction;
    if (w <= 0.0 || w * w >= 4.0 * z)
        throw std::invalid_argument(
            "heat_of_reaction gives a front that does not swing; that takes 0 < z Theta < 2 sqrt "
            "z");
    const std::complex<double> lambda(0.5 * w, std::sqrt(z - 0.25 * w * w));
    const std::complex<double> growth = (w - 1.0) * lambda - z;
    mode_ = {.growth = growth,
             .depth_decay = lambda,
             .own_heat = -(1.0 + front_.reaction * growth) / lambda};
}

double heat_of_reaction_at_onset(SlabConditions conditions) {
    const auto excess = [&](double heat_of_reaction) {
        conditions.material.heat_of_reaction = heat_of_reaction;
        const SteadyFront front = steady_front(conditions);
        return front.sensitivity * front.reaction -
               0.5 * (1.0 + std::sqrt(1.0 + 8.0 * front.sensitivity));
    };
    double high = conditions.material.specific_heat * conditions.cold_temperature;
    while (excess(high) < 0.0) high *= 2.0;
    return bracketed_root(excess, 0.0, high);
}

}  // namespace crawford::reference
