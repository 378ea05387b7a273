/// What one run found, what it cost and how it ended: the only thing that judgements and pages are
/// made of.
#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/errors.hpp"
#include "base/work_done.hpp"
#include "reports/figure_contents.hpp"
#include "reports/measurement.hpp"
#include "reports/setting.hpp"

namespace crawford::reports {

/// What a run has taken.
struct Cost {
    double wall_seconds = 0.0;
    double cpu_seconds = 0.0;    ///< of the thread that ran it
    long peak_memory_bytes = 0;  ///< of the whole program up to the end of the run
    WorkDone work = {};          ///< steps, cells, solver iterations
};

/// How a run has ended.
struct Ending {
    enum class Kind {
        done,
        refused,  ///< the input was wrong: nothing was computed
        failed    ///< the numbers failed, or the program did
    };

    Kind kind = Kind::done;
    std::string message = {};                   ///< why it is not done
    std::optional<FailureFields> failure = {};  ///< where the numbers failed: module, place, limit

    bool is_done() const { return kind == Kind::done; }
};

/// "done", "refused", "failed".
std::string_view name(Ending::Kind kind);

/// The ending of a run that threw.
Ending ending_of(const std::exception_ptr& problem);

struct Record {
    std::string experiment;  ///< for example the name of a study
    Setting setting;
    std::optional<Measurement> found;  ///< where the run is done
    Cost cost = {};
    Ending ending = {};
    std::string fingerprint = {};          ///< of what the answer depends on besides the setting
    std::vector<std::string> scenes = {};  ///< TOML, where the run says what it burnt
    std::optional<FigureContents> figure = {};  ///< where the run has drawn one
    std::string said = {};  ///< what the solver said of a run whose words are judged
};

/// Runs `measure` and books what it took and how it ended.
/// \throws std::bad_alloc where memory is short: that is no ending of the run
Record record_of(const std::string& experiment, const Setting& setting,
                 const std::function<Measurement(const Setting&)>& measure);

/// The same for a run that leaves more than numbers: `run` fills the record.
Record record_of(const std::string& experiment, const Setting& setting,
                 const std::function<void(Record&)>& run);

}  // namespace crawford::reports
