/// What the ledger burns: a scene of cases/scenes at some resolution, under some reading.
#pragma once

#include <string>
#include <vector>

#include "cases/kept_burn.hpp"
#include "cases/registry.hpp"
#include "reports/measurement.hpp"

namespace crawford::ledger {

/// Grid and time of a run.
struct Resolution {
    int nx, ny;
    double step;  ///< [s]
    double end;   ///< [s]
};

/// A scene of cases/scenes that is burnt with and without mechanics.
class Subject {
public:
    /// \throws InputError if `file` is none of cases/scenes.
    explicit Subject(std::string file, double checkpoint_every = 0.02)
        : file_(std::move(file)), checkpoint_every_(checkpoint_every) {}

    /// With some keys set, "dotted.key=value"; it goes on to `end` even if it is steady before.
    Scene coupled(const Resolution& resolution, const std::vector<std::string>& set = {}) const;
    /// The same as a rigid conductor.
    Scene rigid(const Resolution& resolution, const std::vector<std::string>& set = {}) const;

private:
    Scene scene(const Resolution& resolution, std::vector<std::string> set, bool mechanics) const;

    std::string file_;
    double checkpoint_every_;  ///< [s]
};

/// "120 x 96 cells, steps of 25 us"
std::string text(const Resolution& resolution);

/// Adds the axes columns, rows, step [us] and end [ms].
reports::Setting with(reports::Setting setting, const Resolution& resolution);

/// Number `what` of a burn.
struct Measure {
    const char* what;
    const char* unit;
    double (*of)(const Burn&);  ///< in `unit`
};

/// As a case finds it, named as the measure is, after `prefix`.
Finding finding(const Measure& measure, const Burn& burn, const std::string& prefix = {});

/// Mean of the whole course of a burn, ignition and all: "the mean value for the time series".
double mean(const std::vector<double>& course);

/// Sample standard deviation.
double deviation(const std::vector<double>& values);

/// The course's numbers of a burning pack.
extern const Measure mean_burn_rate_of_all, regression_rate_of_all, mean_temperature, mean_strain,
    mean_strain_about_peak, mean_pressure_about_peak, relief;

/// The last numbers of a burning sandwich; the profile is as in Fig. 11, above the edge of the
/// window.
extern const Measure last_burn_rate, last_regression_rate, last_temperature, last_strain,
    last_strain_about_peak, last_pressure_about_peak, outward_displacement, height_of_profile;

/// Those that are refined, and of packs also spread.
std::vector<Measure> pack_measures();
std::vector<Measure> rigid_pack_measures();
std::vector<Measure> sandwich_measures();
std::vector<Measure> rigid_sandwich_measures();

/// All of these of one burn, by their names.
reports::Measurement measured(const Burn& burn, const std::vector<Measure>& measures);

}  // namespace crawford::ledger
