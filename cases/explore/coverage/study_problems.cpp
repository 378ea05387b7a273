/// Values that studies of the catalogue measure themselves.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "cases/explore/coverage/known_problem.hpp"

namespace crawford {

namespace {

/// A number of a study that is given as it is off, in any unit: its truth is `truth`, and what is
/// told is `truth` plus what it is off.
struct Wanted {
    std::string quantity;
    double truth;
};

reports::Study study_of(const std::string& entry, const std::string& name) {
    const auto at = std::ranges::find(catalogue(), entry, &Entry::name);
    if (at == catalogue().end()) throw std::logic_error("no entry " + entry);
    const std::vector<reports::Study> studies = at->studies();
    const auto found = std::ranges::find(studies, name, &reports::Study::name);
    if (found == studies.end()) throw std::logic_error("no study " + name);
    return *found;
}

KnownProblem of(const std::string& kind, const std::string& entry, const std::string& name,
                double order, const std::vector<int>& grids, const std::vector<Wanted>& wanted) {
    return {kind, name, order, grids, [=](int grid) {
                const reports::Study study = study_of(entry, name);
                reports::Record record{
                    .experiment = name, .setting = study.setting(grid), .found = {}};
                study.run()(record);
                const reports::Measurement& found = record.found.value();
                std::vector<KnownValue> values;
                for (const Wanted& w : wanted)
                    values.push_back(
                        {w.quantity, w.truth + found.value_of(w.quantity).value(), w.truth});
                return values;
            }};
}

}  // namespace

std::vector<KnownProblem> study_problems(Fidelity fidelity) {
    const bool draft = fidelity == Fidelity::draft;
    using Grids = std::vector<int>;
    std::vector<KnownProblem> problems;
    problems.push_back(of("ripple", "ripple", "ripple", 2.0,
                          draft ? Grids{16, 24, 32, 48, 64} : Grids{16, 24, 32, 48, 64, 96},
                          {{"rate/exact - 1", 1.0}}));
    problems.push_back(of("cold sandwich", "sandwich-mechanical", "sandwich-mechanical", 1.0,
                          grids_of(fidelity, 8),
                          {{"v, AP surface at x = 120 um [%]", 100.0},
                           {"v, binder surface at x = 0 [%]", 100.0},
                           {"p, binder axis 120 um deep [%]", 100.0}}));
    // Steps and rows go by multiples of 48.
    for (const std::string name : {"response, rigid AP", "response, rigid binder"}) {
        std::vector<Wanted> wanted;
        for (const int hertz : {10, 50, 150, 500, 1500, 5000}) {
            wanted.push_back({fmt::format("amplitude/exact - 1 at {} Hz", hertz), 1.0});
            wanted.push_back({fmt::format("phase - exact [deg] at {} Hz", hertz), 90.0});
        }
        problems.push_back(of("response", "response", name, 2.0,
                              draft ? Grids{48, 96, 144} : Grids{48, 96, 144, 192}, wanted));
    }
    return problems;
}

}  // namespace crawford
