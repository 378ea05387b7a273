#include "solver/files/manifest_outcome.hpp"

#include <array>

namespace crawford {

namespace {

using Kind = ManifestOutcome::Kind;

struct Word {
    Kind kind;
    std::string_view text;
    bool has_reason;
};

constexpr std::array words{
    Word{Kind::running, "running", false},         Word{Kind::done, "done", false},
    Word{Kind::interrupted, "interrupted", false}, Word{Kind::failed, "failed: ", true},
    Word{Kind::cut_off, "cut off: ", true},
};

}  // namespace

std::string text_of(const ManifestOutcome& outcome) {
    for (const Word& word : words)
        if (word.kind == outcome.kind) return std::string(word.text) + outcome.reason;
    return {};
}

std::optional<ManifestOutcome> manifest_outcome(std::string_view text) {
    for (const Word& word : words) {
        if (word.has_reason ? !text.starts_with(word.text) : text != word.text) continue;
        return ManifestOutcome{word.kind, std::string(text.substr(word.text.size()))};
    }
    return {};
}

}  // namespace crawford
