/// Seconds spent in each module of a step.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace crawford {

struct ModuleTime {
    std::string module;
    double seconds;
};

class Stopwatch {
public:
    /// Runs `work` and books its time under `module`.
    template <class Work>
    auto measure(const std::string& module, const Work& work) {
        const Booking booking(entry(module));
        return work();
    }

    const std::vector<ModuleTime>& modules() const { return modules_; }

private:
    using Clock = std::chrono::steady_clock;

    struct Booking {
        explicit Booking(double& seconds) : total(seconds), start(Clock::now()) {}
        ~Booking() { total += std::chrono::duration<double>(Clock::now() - start).count(); }
        Booking(const Booking&) = delete;
        Booking& operator=(const Booking&) = delete;

        double& total;
        Clock::time_point start;
    };

    double& entry(const std::string& module) {
        for (ModuleTime& known : modules_)
            if (known.module == module) return known.seconds;
        return modules_.emplace_back(ModuleTime{module, 0.0}).seconds;
    }

    std::vector<ModuleTime> modules_;
};

}  // namespace crawford
