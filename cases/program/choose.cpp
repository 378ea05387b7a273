#include "cases/program/choose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "solver/errors.hpp"
#include "solver/scene/nearest_name.hpp"

namespace crawford {

namespace {

using Choice = bool (*)(const Entry&);

bool can_be_drawn(const Entry& entry) {
    return bool(entry.draw);
}

bool can_be_verified(const Entry& entry) {
    return bool(entry.studies);
}

std::vector<const Entry*> all(Choice fits) {
    std::vector<const Entry*> chosen;
    for (const Entry& entry : catalogue())
        if (fits(entry)) chosen.push_back(&entry);
    return chosen;
}

std::vector<const Entry*> choose(const std::vector<std::string>& names, const char* kind,
                                 Choice fits, Choice otherwise, const char* instead) {
    const auto candidates = all(fits);
    std::vector<std::string> known;
    for (const Entry* entry : candidates) known.push_back(entry->name);

    std::vector<const Entry*> chosen;
    for (const std::string& name : names) {
        const auto found = std::ranges::find(candidates, name, &Entry::name);
        if (found != candidates.end()) {
            if (std::ranges::find(chosen, *found) == chosen.end()) chosen.push_back(*found);
            continue;
        }
        const auto other = std::ranges::find(catalogue(), name, &Entry::name);
        if (other != catalogue().end() && otherwise(*other))
            throw InputError(
                fmt::format("{} is no {}; use crawford {} {}", name, kind, instead, name));
        throw InputError(fmt::format("no {} is called {}{}", kind, name, suggestion(name, known)));
    }
    return chosen;
}

}  // namespace

std::vector<const Entry*> choose_cases(const std::vector<std::string>& names) {
    return choose(names, "case", can_be_drawn, can_be_verified, "verify");
}

std::vector<const Entry*> choose_studies(const std::vector<std::string>& names) {
    if (names.empty()) return all(can_be_verified);
    return choose(names, "study", can_be_verified, can_be_drawn, "run");
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
