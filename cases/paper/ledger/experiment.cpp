#include "cases/paper/ledger/experiment.hpp"

#include <stdexcept>

#include "base/errors.hpp"

namespace crawford::ledger {

reports::Measurement found(const reports::Record& record) {
    if (!record.found)
        throw NumericalFailure(record.experiment + ", " + record.setting.text() + ": " +
                               record.ending.message);
    return *record.found;
}

double value(const reports::Measurement& found, const std::string& quantity) {
    const auto value = found.value_of(quantity);
    if (!value) throw std::logic_error("no run of the ledger has found \"" + quantity + '"');
    return *value;
}

}  // namespace crawford::ledger
