/// One burn of the trade of cost for accuracy: a subject and what is changed about it.
#pragma once

#include <string>
#include <vector>

#include "reports/record.hpp"
#include "solver/scene/scene.hpp"

namespace crawford::tradeoff {

/// What is burnt, and when it is looked at.
struct Subject {
    std::string name;                  ///< "sandwich, rigid"
    std::string file;                  ///< below cases/scenes/
    std::vector<std::string> changes;  ///< of the file, for all its trials ("dotted.key=value")
    double from, to;                   ///< what is found is found between these times [s]
    int profile;                       ///< points of the surface that are compared; 0: none
};

struct Trial {
    std::string subject;
    std::string knob;                  ///< what it turns; "truth" and "check of the truth" none
    std::vector<std::string> changes;  ///< of the subject
};

Scene scene_of(const Subject& subject, const Trial& trial);

/// By which its record is known: the subject, and what is changed.
reports::Setting setting_of(const Trial& trial);

/// Names of what a trial finds; each has an error of its own.
namespace quantity {
inline constexpr auto regression_rate = "regression rate";  ///< V [m/s]
inline constexpr auto mean_burn_rate = "mean burn rate";    ///< [m/s]
inline constexpr auto max_temperature = "max T";            ///< [K]
inline constexpr auto strain = "strain within 5 um";
inline constexpr auto pressure = "pressure within 5 um";  ///< [Pa]
inline constexpr auto profile = "surface profile";        ///< [m], about its mean
}  // namespace quantity

/// Burns it and finds what there is to find.
/// \throws InputError, NumericalFailure as the burn does: those are results as well.
reports::Measurement measure(const Subject& subject, const Trial& trial);

}  // namespace crawford::tradeoff
