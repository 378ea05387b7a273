/// The ledger's numbers on finer grids, with shorter steps and with other packs.
#pragma once

#include "cases/paper/ledger/subject.hpp"
#include "reports/ledger.hpp"

namespace crawford::ledger {

/// Runs that differ in one size only.
struct Series {
    std::string of;         ///< "pack", "burning sandwich"
    std::string direction;  ///< "x", "y", "x and y", "dt"
    Subject subject;
    std::vector<Resolution> resolutions;  ///< coarsest first
    size_t used;                          ///< the one whose size the ledger's numbers have
    bool mechanics = true;
    std::vector<Measure> measures;

    Scene scene(const Resolution& resolution) const {
        return mechanics ? subject.coupled(resolution) : subject.rigid(resolution);
    }
};

/// All series at a fidelity: what refines the numbers of cases drawn at it.
std::vector<Series> all_series(Fidelity fidelity);
std::vector<Scene> scenes_of(const Series& series);

/// One refinement for each of its measures, from burns that are there. Orders are held against 1:
/// steps are the paper's, first order, and so are stresses and temperatures beside an interface
/// that the grid does not follow.
/// \throws NumericalFailure if a burn failed.
std::vector<reports::Refinement> refinements(const Series& series, const Request& request);

/// The index of a quantity in a direction; nothing if it was not refined there or diverges: what
/// has no limit has no distance to it.
std::optional<double> index(const std::vector<reports::Refinement>& refinements,
                            const std::string& of, const std::string& quantity,
                            const std::string& direction);

/// A sentence with the values on all grids if a quantity diverges in a direction, else nothing.
std::string divergence(const std::vector<reports::Refinement>& refinements, const std::string& of,
                       const std::string& quantity, const std::string& direction);

/// Packs of the paper's discs, thrown anew.
struct Packs {
    Resolution resolution;
    std::vector<unsigned long> seeds;
};
Packs packs(Fidelity fidelity);

/// What is burnt of each.
std::vector<Scene> scenes_of(const Packs& packs);

/// Mean and spread of the pack's numbers, named as in the rows: rigid, with mechanics ("pack"), and
/// under twice the flux.
std::vector<reports::Spread> spreads(const Packs& packs, const Request& request);

}  // namespace crawford::ledger
