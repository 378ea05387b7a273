/// The pages of what has been drawn: DIR/figures/<case>.html, index.html and ledger.html.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cases/registry.hpp"

namespace crawford {

/// Writes a page for every case whose manifest lies in `out`/figures, one for ledger.json if that
/// is there, and the index of all; quick, since nothing is computed or drawn. Returns the index, or
/// nothing if there is nothing to show.
/// \throws InputError if ledger.json cannot be understood.
std::optional<std::filesystem::path> write_figure_pages(const std::filesystem::path& out);

/// The page of an entry for a reader: the opening comment of its file; empty where the sources are
/// not at hand.
std::string opening_comment_of(const Entry& entry);

}  // namespace crawford
