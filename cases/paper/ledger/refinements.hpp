/// The ledger's numbers on finer grids and with shorter steps.
#pragma once

#include "cases/paper/ledger/experiment.hpp"
#include "cases/paper/ledger/subject.hpp"
#include "reports/ledger.hpp"

namespace crawford::ledger {

/// Runs that differ in one size only. Series of one experiment share those that are the same.
struct Series {
    std::string experiment;
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
std::vector<Series> pack_series(Fidelity fidelity);
std::vector<Series> sandwich_series(Fidelity fidelity);
std::vector<Run> runs(const Series& series);

/// One refinement for each of its measures. Orders are held against 1: steps are the paper's, first
/// order, and so are stresses and temperatures beside an interface that the grid does not follow.
/// \throws NumericalFailure if a run failed.
std::vector<reports::Refinement> refinements(const Series& series, const Records& records);

/// What a refinement says of a quantity that has no limit.
inline constexpr auto diverging = "diverging";

}  // namespace crawford::ledger
