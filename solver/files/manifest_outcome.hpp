/// How far the run of a manifest has come: its member "outcome".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace crawford {

struct ManifestOutcome {
    enum class Kind {
        running,
        done,
        interrupted,
        failed,  ///< its numbers did
        cut_off  ///< disk or memory had no room: it can go on
    };
    Kind kind = Kind::running;
    std::string reason = {};  ///< of the last two
};

/// "running", "done", "interrupted", "failed: REASON", "cut off: REASON".
std::string text_of(const ManifestOutcome& outcome);

/// Nothing if `text` is none of them.
std::optional<ManifestOutcome> manifest_outcome(std::string_view text);

}  // namespace crawford
