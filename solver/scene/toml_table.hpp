/// A table of a scene file that checks what is taken from it and notices what nobody took.
#pragma once

#include <toml++/toml.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/scene/limits.hpp"

namespace crawford {

/// Every value is asked for by its key; finish() then refuses what is left over and what was
/// missing. A value that is absent leaves its variable as it was.
///
/// All functions throw InputError, one line:
/// "FILE:LINE: table.key = VALUE what is wrong; what to do".
class TomlTable {
public:
    /// A view: `table` must outlive it, because a copy of a toml::table forgets the lines it was
    /// read from. `path` is the dotted name of the table, empty for the root; `where` is the file,
    /// for tables that are absent.
    TomlTable(const toml::table* table, std::string path, std::string where);

    bool has(std::string_view key) const { return table_->contains(key); }
    std::vector<std::string> keys() const;
    /// "FILE:LINE: table.key", for messages of one's own.
    std::string name(std::string_view key) const;

    /// A string with a number and a unit, in SI.
    void quantity(std::string_view key, double& value, const Limits&, Need = Need::optional);
    void quantity(std::string_view key, std::optional<double>& value, const Limits&);
    /// A required quantity, or a word in its place.
    void quantity_or(std::string_view word, bool& is_word, std::string_view key, double& value,
                     const Limits&);
    /// A pure number.
    void number(std::string_view key, double& value, const Limits&, Need = Need::optional);
    void number(std::string_view key, std::optional<double>& value, const Limits&);
    void integer(std::string_view key, int& value, const IntegerLimits&, Need = Need::optional);
    void flag(std::string_view key, bool& value);
    void text(std::string_view key, std::string& value, Need = Need::optional);
    /// A table of this table; an empty one where it is absent.
    TomlTable table(std::string_view key);
    /// The tables of an array of tables.
    std::vector<TomlTable> tables(std::string_view key);
    bool is_table(std::string_view key) const {
        return table_->get_as<toml::table>(key) != nullptr;
    }

    /// One of a few words.
    template <class Choice, std::size_t n>
    void choice(std::string_view key, Choice& value, const std::array<Word<Choice>, n>& words) {
        std::vector<std::string> known;
        for (const auto& word : words) known.emplace_back(word.word);
        if (const auto index = index_of(key, known)) value = words[*index].meaning;
    }

    /// Index of the string at `key` in `known`; none where the key is absent.
    std::optional<std::size_t> index_of(std::string_view key, const std::vector<std::string>& known,
                                        Need = Need::optional);

    /// Marks a key as known although the scene at hand has no use for it.
    void allow(std::string_view key) { known_.emplace_back(key); }

    /// To be called once all keys have been asked for. `remark` is added where a key is missing.
    void finish(std::string_view remark = {}) const;

    [[noreturn]] void refuse(std::string_view key, std::string_view what) const;

private:
    const toml::node* find(std::string_view key, Need need);
    void check_interval(std::string_view key, double value, const Limits&) const;
    [[noreturn]] void refuse_type(std::string_view key, std::string_view expected) const;

    const toml::table* table_;
    std::string path_, where_;
    std::vector<std::string> known_;    ///< the keys asked for
    std::vector<std::string> missing_;  ///< the keys required and absent
};

}  // namespace crawford
