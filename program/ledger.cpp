#include "reports/ledger.hpp"

#include <fmt/format.h>

#include <chrono>
#include <iostream>
#include <stdexcept>

#include "base/errors.hpp"
#include "base/source_tree.hpp"
#include "cases/burn_store.hpp"
#include "cases/paper/ledger/ledger.hpp"
#include "program/burning.hpp"
#include "program/choose.hpp"
#include "program/commands.hpp"
#include "program/figure_record.hpp"
#include "program/narrator.hpp"
#include "program/pages.hpp"
#include "program/provenance.hpp"
#include "program/queue.hpp"
#include "reports/figure.hpp"

namespace crawford {

namespace {

using Clock = std::chrono::steady_clock;

/// The ledger that was settled last, as it lies in the tree.
reports::Ledger settled_before() {
    try {
        return reports::read_ledger(source_path("results/ledger.json"));
    } catch (const std::runtime_error& problem) {
        throw InputError(fmt::format("{}; crawford ledger --settle finds it anew", problem.what()));
    }
}

double found(const std::filesystem::path& figures, const std::string& entry,
             const std::string& what) {
    const auto record = read_figure_record(figures, entry);
    if (record)
        for (const Finding& finding : record->findings)
            if (finding.what == what) return finding.value;
    throw std::logic_error(fmt::format("{} has not found \"{}\"", entry, what));
}

reports::Ledger settle(const LedgerOptions& options, const CommandLine& command) {
    const auto started = Clock::now();
    const Fidelity fidelity = fidelity_of(options.fidelity);
    if (run({.cases = ledger::cited_cases(),
             .fidelity = options.fidelity,
             .out = options.out,
             .quiet = options.quiet},
            command) != exit_code::done)
        throw NumericalFailure("a case that the ledger cites could not be drawn");

    Narrator narrator(options.quiet);
    run_told(burnings(ledger::scenes(fidelity), fidelity, options.out), narrator,
             [&](const Job& job, const std::exception_ptr&) {
                 narrator.say(job.name + " failed: its reading has no numbers");
             });
    auto settled = ledger::settle({.fidelity = fidelity, .out = options.out, .progress = {}},
                                  [&](const std::string& entry, const std::string& what) {
                                      return found(options.out / "figures", entry, what);
                                  });
    settled.manifest = provenance(command);
    settled.manifest["fidelity"] = options.fidelity;
    settled.manifest["wall_seconds"] =
        std::chrono::duration<double>(Clock::now() - started).count();
    return settled;
}

void tell(const reports::Ledger& ledger) {
    for (const auto& row : ledger.rows)
        std::cout << fmt::format("{:<9} {:<54.54} {:>12.12}  {}\n", row.where, row.claim,
                                 row.value ? row.ours : "in words", name(row.standing));
}

}  // namespace

int settle_ledger(const LedgerOptions& options, const CommandLine& command) {
    const auto ledger = options.settle ? settle(options, command) : settled_before();
    const auto file = options.out / "figures" / "ledger.json";
    reports::write(file, ledger);
    write_figure_pages(options.out);
    tell(ledger);
    std::cout << "ledger: " << file.string() << '\n';
    return exit_code::done;
}

}  // namespace crawford
