#include "reports/record.hpp"

#include <chrono>

#include "base/errors.hpp"
#include "base/peak_memory.hpp"
#include "base/room.hpp"
#include "base/thread_time.hpp"

namespace crawford::reports {

std::string_view name(Ending::Kind kind) {
    switch (kind) {
        case Ending::Kind::done:
            return "done";
        case Ending::Kind::refused:
            return "refused";
        default:
            return "failed";
    }
}

Ending ending_of(const std::exception_ptr& problem) {
    try {
        std::rethrow_exception(problem);
    } catch (const InputError& error) {
        return {Ending::Kind::refused, error.what(), {}};
    } catch (const NumericalFailure& error) {
        return {Ending::Kind::failed, error.what(), error.fields()};
    } catch (const std::exception& error) {
        return {Ending::Kind::failed, error.what(), {}};
    } catch (...) {
        return {Ending::Kind::failed, "unknown exception", {}};
    }
}

Record record_of(const std::string& experiment, const Setting& setting,
                 const std::function<Measurement(const Setting&)>& measure) {
    return record_of(experiment, setting, [&](Record& record) { record.found = measure(setting); });
}

Record record_of(const std::string& experiment, const Setting& setting,
                 const std::function<void(Record&)>& run) {
    const auto start = std::chrono::steady_clock::now();
    const double cpu = seconds_of_this_thread();
    work_of_this_thread() = {};
    Record record{.experiment = experiment, .setting = setting, .found = {}};
    try {
        run(record);
    } catch (...) {
        if (is_out_of_memory(std::current_exception())) throw;  // says nothing of what was run
        record.ending = ending_of(std::current_exception());
    }
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    record.cost = {wall.count(), seconds_of_this_thread() - cpu, peak_memory(),
                   work_of_this_thread()};
    return record;
}

}  // namespace crawford::reports
