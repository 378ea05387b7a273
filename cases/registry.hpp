/// The catalogue: every case and study, registered by its own file. Adding one touches no other
/// file.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/job_queue.hpp"
#include "cases/physics.hpp"
#include "reports/figure.hpp"
#include "reports/study.hpp"
#include "solver/scene/scene.hpp"

namespace crawford {

namespace ledger {
struct Evidence;
}
namespace reports {
struct LedgerRow;
}

enum class Fidelity {
    draft,  ///< seconds: coarse, to look at
    paper,  ///< the paper's grid and step
    fine    ///< beyond it
};

/// What `crawford run` wants of a case.
struct Request {
    Fidelity fidelity = Fidelity::paper;
    std::filesystem::path out;  ///< figures go to out/figures
    /// Called now and then from a long run: what is running and how much of it is done, 0 to 1.
    std::function<void(const std::string& what, double done)> progress;
};

/// A number that a case has found.
struct Finding {
    std::string what;
    double value;
    std::string unit;
};

/// What a case hands back: the picture, ready to be drawn, and what it rests on.
struct Outcome {
    reports::Figure figure;
    std::vector<Finding> findings;
    std::vector<Scene> scenes;  ///< for the manifest
};

/// Measured wall time on two cores [s]: of a picture as draft and as in the paper; of a study, one.
struct Cost {
    double draft = 0.0;
    double paper = 0.0;
    double verify = 0.0;
};

/// Runs that claims of the paper are judged by, besides those that figures show: readings and
/// refinements of the burning sandwich; those of the pack, and other packs (cases/paper/ledger).
enum class LedgerRuns { none, sandwich, pack };

/// A line of the catalogue. It can be drawn, verified, or both.
struct Entry {
    std::string name;
    std::string figure;  ///< of the paper; "-" if there is none
    std::string shows;
    std::vector<std::string> physics = {};  ///< headings of physics.hpp, besides what studies cover
    Cost cost = {};
    std::function<Outcome(const Request&)> draw = {};
    /// The scenes whose burns `draw` will ask for (kept_burn.hpp), so that they can be made side
    /// by side before.
    std::function<std::vector<Scene>(Fidelity)> burns = {};
    /// What else `draw` will look for among the records of `out`: made side by side before.
    std::function<std::vector<Job>(Fidelity, const std::filesystem::path& out)> jobs = {};
    /// Draws <case>.gif instead, for `crawford run --movie`; and the burns that it will ask for.
    std::function<Outcome(const Request&)> draw_movie = {};
    std::function<std::vector<Scene>(Fidelity)> movie_burns = {};
    std::function<std::vector<reports::Study>()> studies = {};
    /// The claims of the paper that this case shows, judged by what has been found: rows of the
    /// ledger, made of records and nothing else (cases/paper/ledger/evidence.hpp).
    std::function<std::vector<reports::LedgerRow>(const ledger::Evidence&)> claims = {};
    LedgerRuns claims_rest_on = LedgerRuns::none;
    std::filesystem::path source = {};  ///< "cases/<file>.cpp"; filled in when it registers
};

/// All entries, by name.
const std::vector<Entry>& catalogue();

/// Puts an entry into the catalogue before main() begins: const Registered here{{...}}; in the file
/// of the case, which is how the entry knows its file.
struct Registered {
    explicit Registered(Entry entry, const std::filesystem::path& file = __builtin_FILE());
};

}  // namespace crawford
