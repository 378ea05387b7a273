/// The run that `crawford verify --against` holds this one against.
#pragma once

#include <optional>
#include <vector>

#include "program/commands.hpp"
#include "reports/against.hpp"
#include "reports/verification.hpp"

namespace crawford {

class EarlierRun {
public:
    /// Reads it, if one is named.
    /// \throws InputError if it cannot be read or understood, or the factor is none.
    explicit EarlierRun(const VerifyOptions& options);

    /// Prints what has become of its gates. False if that is to end with exit code 1.
    bool tell(const reports::Verification& found, bool grids_were_chosen) const;

private:
    std::optional<std::vector<reports::GateResult>> gates_;
    reports::Yardstick yardstick_;
    bool every_study_;
};

}  // namespace crawford
