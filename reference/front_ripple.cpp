#include "reference/front_ripple.hpp"

#include <stdexcept>

#include "reference/require.hpp"

namespace crawford::reference {

FrontRipple::FrontRipple(const SlabConditions& conditions, double wave_number)
    : front_(steady_front(conditions)) {
    require_positive("wave_number", wave_number);
    const auto modes = front_modes(front_, wave_number / front_.wave_number());
    if (modes.empty() || modes.front().growth.imag() != 0.0)
        throw std::invalid_argument(
            "heat_of_reaction is too large: ripples swing, and none just dies");
    mode_ = modes.front();
}

double FrontRipple::growth_rate() const {
    return front_.rate_unit() * mode_.growth.real();
}

double FrontRipple::temperature(double eta) const {
    return mode_.temperature(front_, eta).real();
}

}  // namespace crawford::reference
