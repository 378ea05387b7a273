/// Many burns that differ in their packs, gathered to points of like conditions: what is the mean,
/// and how well is it known?
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reports/spread.hpp"

namespace crawford::reports {

struct EnsembleQuantity {
    const char* name;
    const char* symbol;  ///< for names of files and columns
    const char* unit;
};

/// What is gathered, in this order everywhere.
inline constexpr std::array ensemble_quantities{
    EnsembleQuantity{"regression rate V", "V", "cm/s"},
    EnsembleQuantity{"mean burn rate", "mean burn rate", "cm/s"},
    EnsembleQuantity{"largest temperature", "max T", "K"},
    EnsembleQuantity{"largest strain within 5 um of its maximum", "strain within 5 um", "-"}};

/// What the burns of a point share and points differ in.
struct Conditions {
    double area_fraction;  ///< of the particles; NaN where there are none
    double pressure;       ///< [Pa]
    std::string readings;  ///< "paper", "consistent", or "of its own"
    int columns, rows;
    double end;    ///< [s]
    double after;  ///< from when on a burn counts [s]

    auto operator<=>(const Conditions&) const = default;
};

struct EnsembleBurn {
    std::string key;   ///< of its scene
    std::string rest;  ///< a digest of all that the burns of its point share, conditions included
    Conditions conditions;
    std::string seed;
    std::string state;                                      ///< "done", or how else it ended
    std::string reason;                                     ///< if it failed
    std::array<double, ensemble_quantities.size()> values;  ///< NaN of one that is not done

    bool is_done() const { return state == "done"; }
};

struct EnsemblePoint {
    Conditions conditions;
    long burns;  ///< of which those that are done count
    std::array<Spread, ensemble_quantities.size()> spreads;
    std::array<std::optional<long>, ensemble_quantities.size()> needed;  ///< packs
};

struct EnsembleDemand {
    double interval = 0.01;    ///< half-width of the confidence interval, of the mean
    double confidence = 0.95;  ///< that it holds the mean of all packs
};

struct Ensemble {
    EnsembleDemand demand;
    std::vector<EnsembleBurn> burns;    ///< each scene once, by conditions, then seed
    std::vector<EnsemblePoint> points;  ///< by conditions
};

/// Burns of one key count once: they have the same bits.
Ensemble gather(std::vector<EnsembleBurn> burns, const EnsembleDemand& demand);

/// A row a point, every column with its unit; numbers with all digits, "nan" where there is none.
std::string points_csv(const Ensemble& ensemble);

/// A row a burn, those that failed as well.
std::string burns_csv(const Ensemble& ensemble);

}  // namespace crawford::reports
