#include "program/choose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"

namespace crawford {

namespace {

/// The entry of this name; null if there is none.
const Entry* find(const std::string& name) {
    const auto found = std::ranges::find(catalogue(), name, &Entry::name);
    return found == catalogue().end() ? nullptr : &*found;
}

const Entry* case_of(const std::string& name) {
    const Entry* entry = find(name);
    if (entry != nullptr && entry->draw) return entry;
    if (entry != nullptr)
        throw InputError(fmt::format("{0} is no case; use crawford verify {0}", name));
    std::vector<std::string> known;
    for (const Entry& other : catalogue())
        if (other.draw) known.push_back(other.name);
    throw InputError(fmt::format("no case is called {}{}", name, suggestion(name, known)));
}

std::vector<ChosenStudy> all_studies() {
    std::vector<ChosenStudy> all;
    for (const Entry& entry : catalogue()) {
        if (!entry.studies) continue;
        const auto studies = entry.studies();
        for (const reports::Study& study : studies)
            all.push_back({.entry = &entry,
                           .study = study,
                           .name = studies.size() == 1 ? entry.name : study.name(),
                           .seconds = entry.cost.verify / double(studies.size())});
    }
    return all;
}

[[noreturn]] void refuse_study(const std::string& name, const std::vector<ChosenStudy>& all) {
    if (find(name) != nullptr)
        throw InputError(fmt::format("{0} is no study; use crawford run {0}", name));
    std::vector<std::string> entries;
    std::vector<std::string> names;
    for (const ChosenStudy& study : all) {
        if (std::ranges::find(entries, study.entry->name) == entries.end())
            entries.push_back(study.entry->name);
        names.push_back(study.study.name());
    }
    names.insert(names.end(), entries.begin(), entries.end());
    const bool is_near = !nearest_name(name, names).empty();
    throw InputError(
        fmt::format("no study is called {}{}", name, suggestion(name, is_near ? names : entries)));
}

}  // namespace

std::vector<const Entry*> all_cases() {
    std::vector<const Entry*> all;
    for (const Entry& entry : catalogue())
        if (entry.draw) all.push_back(&entry);
    return all;
}

std::vector<const Entry*> choose_cases(const std::vector<std::string>& names) {
    std::vector<const Entry*> chosen;
    for (const std::string& name : names) {
        const Entry* entry = case_of(name);
        if (std::ranges::find(chosen, entry) == chosen.end()) chosen.push_back(entry);
    }
    return chosen;
}

std::vector<ChosenStudy> choose_studies(const std::vector<std::string>& names) {
    auto all = all_studies();
    const auto is_called = [](const ChosenStudy& study, const std::string& name) {
        return study.entry->name == name || study.study.name() == name;
    };
    for (const std::string& name : names)
        if (std::ranges::none_of(all, [&](const auto& study) { return is_called(study, name); }))
            refuse_study(name, all);
    if (names.empty()) return all;
    std::vector<ChosenStudy> chosen;
    for (const ChosenStudy& study : all)
        if (std::ranges::any_of(names, [&](const auto& name) { return is_called(study, name); }))
            chosen.push_back(study);
    return chosen;
}

Fidelity fidelity_of(const std::string& word) {
    const std::vector<std::string> words = {"draft", "paper", "fine"};
    constexpr std::array meanings = {Fidelity::draft, Fidelity::paper, Fidelity::fine};
    const auto found = std::ranges::find(words, word);
    if (found == words.end())
        throw InputError(fmt::format("--fidelity = {} is none of draft, paper, fine{}", word,
                                     nearest_name(word, words).empty() ? std::string("; choose one")
                                                                       : suggestion(word, words)));
    return meanings[size_t(found - words.begin())];
}

}  // namespace crawford
