#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "cases/program/choose.hpp"
#include "cases/program/commands.hpp"
#include "cases/program/failure.hpp"
#include "cases/program/narrator.hpp"
#include "cases/program/provenance.hpp"
#include "reports/atomic_file.hpp"
#include "solver/output/atomic_file.hpp"
#include "solver/scene/write_scene.hpp"

namespace crawford {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Draws cases side by side; every thread takes the next that nobody has begun.
class Run {
public:
    Run(const RunOptions& options, const CommandLine& command)
        : command_(command),
          chosen_(choose_cases(options.cases)),
          fidelity_word_(options.fidelity),
          narrator_(options.quiet) {
        request_.fidelity = fidelity_of(options.fidelity);
        request_.out = options.out;
        request_.progress = [this](const std::string& what, double done) {
            narrator_.progress(what, done);
        };
        prepare_directory(request_.out / "figures");
    }

    int all() {
        const size_t threads =
            std::min<size_t>(std::max(1U, std::thread::hardware_concurrency()), chosen_.size());
        std::vector<std::future<void>> workers;
        for (size_t k = 0; k < threads; ++k)
            workers.push_back(std::async(std::launch::async, [this] { take_cases(); }));
        for (auto& worker : workers) worker.get();
        return worst_;
    }

private:
    void take_cases() {
        for (size_t k = next_++; k < chosen_.size(); k = next_++) try_one(*chosen_[k]);
    }

    void try_one(const Entry& entry) {
        try {
            draw(entry);
        } catch (...) {
            const Failure failure = failure_of(std::current_exception());
            const std::scoped_lock lock(mutex_);
            std::cerr << fmt::format("crawford run: {}: {}\n", entry.name, failure.message);
            worst_ = std::max(worst_, failure.exit_code);
        }
    }

    void draw(const Entry& entry) {
        narrator_.say(fmt::format("{}: {} ...", entry.name, entry.shows));
        const auto start = Clock::now();
        const Outcome outcome = entry.draw(request_);
        const auto pictures = outcome.figure.draw();
        write_manifest(entry, outcome, seconds_since(start));
        narrator_.say(fmt::format("{}: done in {:.1f} s", entry.name, seconds_since(start)));
        tell(entry, outcome, pictures);
    }

    void tell(const Entry& entry, const Outcome& outcome,
              const std::vector<std::filesystem::path>& pictures) {
        const std::scoped_lock lock(mutex_);
        std::cout << fmt::format("{}: {}\n", entry.figure, entry.shows);
        for (const Finding& finding : outcome.findings)
            std::cout << fmt::format("  {:<58} {:>12.6g} {}\n", finding.what, finding.value,
                                     finding.unit);
        for (const auto& picture : pictures) std::cout << "  " << picture.string() << '\n';
    }

    void write_manifest(const Entry& entry, const Outcome& outcome, double seconds) const {
        auto json = provenance(command_);
        json["case"] = entry.name;
        json["fidelity"] = fidelity_word_;
        json["wall_seconds"] = seconds;
        auto& findings = json["findings"] = nlohmann::ordered_json::array();
        for (const Finding& f : outcome.findings)
            findings.push_back({{"what", f.what}, {"value", f.value}, {"unit", f.unit}});
        auto& scenes = json["scenes"] = nlohmann::ordered_json::array();
        for (const Scene& scene : outcome.scenes) scenes.push_back(to_toml(scene));
        reports::write_atomically(request_.out / "figures" / (entry.name + "_manifest.json"),
                                  json.dump(2) + '\n');
    }

    const CommandLine& command_;
    std::vector<const Entry*> chosen_;
    std::string fidelity_word_;
    Narrator narrator_;
    Request request_;
    std::atomic<size_t> next_ = 0;
    std::mutex mutex_;
    int worst_ = exit_code::done;
};

}  // namespace

int run(const RunOptions& options, const CommandLine& command) {
    return Run(options, command).all();
}

}  // namespace crawford
