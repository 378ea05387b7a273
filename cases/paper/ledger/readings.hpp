/// The paper read in other ways, and what then comes out.
#pragma once

#include "cases/paper/ledger/experiment.hpp"
#include "cases/paper/ledger/subject.hpp"
#include "reports/ledger.hpp"

namespace crawford::ledger {

/// One way to read the paper.
struct Reading {
    std::string name;
    std::vector<std::string> set = {};  ///< keys of the scene, as --set takes them
    bool of_rigid = false;              ///< whether it changes the rigid conductor as well
};

/// Quantities of matrices that claims ask for.
namespace quantity {
inline constexpr auto rigid_burn_rate = "burn rate, rigid";
inline constexpr auto burn_rate = "burn rate";
inline constexpr auto change_of_burn_rate = "change of burn rate";
inline constexpr auto rigid_rise = "rise of largest T, rigid";
inline constexpr auto rise = "rise of largest T";
inline constexpr auto largest_strain = "largest strain";
inline constexpr auto strain_about_peak = "strain over 5 um";
inline constexpr auto height_of_profile = "height of the profile";
}  // namespace quantity

/// An experiment: one run a reading, each with mechanics and as a rigid conductor.
struct Readings {
    std::string experiment, title;
    Subject subject;
    Resolution resolution;
    std::vector<Reading> readings;  ///< the first is the one Crawford takes
    std::vector<reports::Quantity> quantities;
    /// Those, from the two burns.
    std::vector<double> (*numbers)(const Burn& coupled, const Burn& rigid);
};
Readings pack_readings(Fidelity fidelity);
Readings sandwich_readings(Fidelity fidelity);

std::vector<Run> runs(const Readings& readings);

/// What the runs have found. One that failed has no numbers and says why.
reports::ReadingMatrix matrix(const Readings& readings, const Records& records);

}  // namespace crawford::ledger
