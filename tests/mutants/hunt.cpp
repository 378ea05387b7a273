#include "hunt.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "base/digest.hpp"

namespace crawford::mutants {

namespace {

const Judge every_test{Judge::Kind::tests, "*"};

bool in_solver(const Fault& fault) {
    return fault.file.starts_with("solver/");
}

/// Whether what a judge sees depends on a file: on all code, but of the studies and tests only on
/// its own.
bool depends_on(const ScratchTree& tree, const Judge& judge, const std::string& file) {
    const auto in = [&](const char* folder) { return file.starts_with(folder); };
    if (in("tests/")) return judge.kind == Judge::Kind::tests && !in("tests/mutants/");
    if (in("cases/") && judge.kind == Judge::Kind::study && tree.registers_studies(file))
        return study_of(file) == judge.name;
    return in("base/") || in("solver/") || in("reference/") || in("reports/") || in("cases/") ||
           in("program/") || in("cmake/") || file == "CMakeLists.txt";
}

}  // namespace

bool Verdict::survived() const {
    return broken.empty() && !killer();
}

const Verdict::Sighting* Verdict::killer() const {
    const auto first =
        std::ranges::find_if(heard, [](const Sighting& s) { return s.finding.killed(); });
    return first == heard.end() ? nullptr : &*first;
}

double Verdict::seconds() const {
    return std::accumulate(heard.begin(), heard.end(), 0.0,
                           [](double sum, const Sighting& s) { return sum + s.finding.seconds; });
}

Hunt::Hunt(const ScratchTree& tree, const Workshop& workshop, Ledger& ledger, HuntOptions options)
    : tree_(tree), workshop_(workshop), ledger_(ledger), options_(std::move(options)) {}

/// The one expected to see it first, then the studies. Faults of the solver must be seen by a study
/// or by the test that the table names; those of truths and of the order engine by any test.
std::vector<Judge> Hunt::judges_of(const Fault& fault) const {
    std::vector<Judge> judges{fault.seen_by};
    for (const std::string& study : options_.studies)
        if (study != fault.seen_by.name) judges.push_back({Judge::Kind::study, study});
    if (!in_solver(fault)) judges.push_back(every_test);
    return judges;
}

std::string Hunt::key(const Judge& judge, const Fault* fault) const {
    const std::string sources =
        tree_.fingerprint([&](const std::string& file) { return depends_on(tree_, judge, file); });
    const std::string change =
        fault ? fmt::format("{}\n{}\n{}", fault->file, fault->from, fault->to) : "sound";
    return digest(fmt::format("{}\n{}\n{}", sources, judge.label(), change));
}

/// A fault may slow a judge down, and the machine may be busy; beyond this it does not end.
double Hunt::limit(const Judge& judge) const {
    const auto sound = ledger_.find(key(judge, nullptr));
    return 60.0 + 5.0 * (sound ? sound->seconds : 0.0);
}

void Hunt::check_sound(const std::vector<Fault>& faults,
                       const std::function<void(const std::string&)>& say) {
    constexpr double patience = 3600.0;
    std::vector<Judge> judges;
    for (const Fault& fault : faults)
        for (const Judge& judge : judges_of(fault))
            if (std::ranges::find(judges, judge) == judges.end()) judges.push_back(judge);

    std::vector<std::string> fallen;
    for (const Judge& judge : judges) {
        const std::string k = key(judge, nullptr);
        if (ledger_.find(k)) continue;
        say(fmt::format("sound sources: {}", judge.label()));
        if (const auto error = workshop_.build(judge); !error.empty())
            throw std::runtime_error("the sound sources do not build:\n" + error);
        const Finding finding = workshop_.ask(judge, patience);
        if (!finding.killed()) ledger_.keep(k, finding);
        fallen.insert(fallen.end(), finding.gates.begin(), finding.gates.end());
    }
    if (!fallen.empty())
        throw std::runtime_error(
            fmt::format("the sound sources fall short, so that nothing can be judged:\n  {}",
                        fmt::join(fallen, "\n  ")));
}

/// What the judge sees of the fault, which is planted no sooner than something has to be built.
/// \throws std::invalid_argument if the fault does not apply or does not build.
Finding Hunt::look(const Judge& judge, const Fault& fault,
                   std::optional<ScratchTree::Planted>& planted) {
    const std::string k = key(judge, &fault);
    if (const auto known = ledger_.find(k)) return *known;
    if (!planted) planted.emplace(tree_, fault);
    if (!workshop_.build(judge).empty())
        throw std::invalid_argument(fault.name + ": does not build");
    Finding finding = workshop_.ask(judge, limit(judge));
    ledger_.keep(k, finding);
    return finding;
}

Verdict Hunt::judge(const Fault& fault) {
    Verdict verdict{fault, {}, ""};
    std::optional<ScratchTree::Planted> planted;
    try {
        for (const Judge& judge : judges_of(fault)) {
            verdict.heard.push_back({judge, look(judge, fault, planted)});
            if (verdict.killer() && !options_.all_studies) break;
        }
    } catch (const std::invalid_argument& problem) {
        verdict.broken = problem.what();
    }
    return verdict;
}

}  // namespace crawford::mutants
