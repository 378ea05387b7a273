#include "program/pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "base/source_tree.hpp"
#include "cases/physics.hpp"
#include "program/choose.hpp"
#include "program/figure_record.hpp"
#include "program/movie.hpp"
#include "reports/figure.hpp"
#include "reports/page/figures.hpp"
#include "reports/page/ledger.hpp"
#include "reports/page/overview.hpp"
#include "reports/page/prose.hpp"
#include "reports/verification.hpp"

namespace crawford {

namespace {

namespace fs = std::filesystem;
namespace page = reports::page;
using Json = nlohmann::ordered_json;

std::vector<std::string> names(const std::vector<fs::path>& files) {
    std::vector<std::string> names;
    for (const fs::path& file : files) names.push_back(file.string());
    return names;
}

/// What the page does not show in a section of its own; empty if there is no manifest.
std::string rest_of_manifest(const fs::path& figures, const std::string& name) {
    std::ifstream file(manifest_of(figures, name));
    auto manifest = Json::parse(file, nullptr, false);
    if (!manifest.is_object()) return "{}";
    for (const char* shown : {"findings", "scenes", "pictures", "data"}) manifest.erase(shown);
    return manifest.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string options_of(const std::string& fidelity, const fs::path& out) {
    const auto options = fmt::format("--fidelity {}", fidelity);
    return out == "out" ? options : fmt::format("{} --out {}", options, out.string());
}

std::string command_of(const Entry& entry, const std::string& fidelity, const fs::path& out) {
    return fmt::format("build/crawford run {} {}", entry.name, options_of(fidelity, out));
}

double cost_of(const Entry& entry, const std::string& fidelity) {
    if (fidelity == "draft") return entry.cost.draft;
    return fidelity == "paper" ? entry.cost.paper : 0.0;
}

std::vector<std::string> movie_files(const Entry& entry, const fs::path& out) {
    auto store = figure_records(out);
    const auto movie = drawn_record(store, movie_name(entry));
    return movie ? names(movie->figure->pictures()) : std::vector<std::string>();
}

/// Nothing if it has not been drawn.
std::optional<page::DrawnCase> drawn(const Entry& entry, const fs::path& out) {
    auto store = figure_records(out);
    const auto record = drawn_record(store, entry.name);
    if (!record) return {};
    const auto fidelity = drawn_at(*record);
    page::DrawnCase drawn{.name = entry.name,
                          .figure = entry.figure,
                          .shows = entry.shows,
                          .physics = physics_of(entry),
                          .prose = opening_comment_of(entry),
                          .source = entry.source.string(),
                          .command = command_of(entry, fidelity, out),
                          .fidelity = fidelity,
                          .seconds = cost_of(entry, fidelity),
                          .pictures = names(record->figure->pictures()),
                          .data = names(record->figure->data()),
                          .scenes = record->scenes,
                          .manifest = rest_of_manifest(out / "figures", entry.name)};
    for (const std::string& name : movie_files(entry, out)) drawn.pictures.push_back(name);
    for (const Finding& finding : findings_of(*record))
        drawn.findings.push_back({finding.what, finding.value, finding.unit});
    return drawn;
}

/// Where the report of the studies lies, seen from the figures, and what it reports.
struct Reported {
    std::string address;  ///< empty if there is none
    std::vector<std::string> entries;
};

Reported reported(const fs::path& out) {
    for (const auto& [directory, address] :
         {std::pair(out / "verify", "../verify/report.html"), std::pair(out, "../report.html")}) {
        if (!fs::exists(directory / "verify.json")) continue;
        try {
            return {address,
                    page::entries_of(reports::read_verification(directory / "verify.json"))};
        } catch (const InputError&) {
            return {};  // crawford report says what is wrong with it
        }
    }
    return {};
}

std::vector<page::VerifyingStudy> studies(const Reported& reported) {
    std::vector<page::VerifyingStudy> studies;
    for (const Entry& entry : catalogue()) {
        if (!entry.studies) continue;
        const bool is_there =
            std::ranges::find(reported.entries, entry.name) != reported.entries.end();
        studies.push_back(
            {.name = entry.name,
             .shows = entry.shows,
             .physics = physics_of(entry),
             .address = is_there ? reported.address + '#' + page::anchor_of_entry(entry.name)
                                 : std::string()});
    }
    return studies;
}

std::optional<reports::Ledger> ledger(const fs::path& file) {
    if (!fs::exists(file)) return {};
    try {
        return reports::read_ledger(file);
    } catch (const InputError& problem) {
        throw InputError(fmt::format("{}; crawford ledger writes it anew", problem.what()));
    }
}

void add_missing(page::FigureBook& book, const Entry& entry, const fs::path& out) {
    book.not_drawn.push_back(entry.name);
    for (const std::string& name : movie_files(entry, out)) book.movies.push_back(name);
}

page::FigureBook book_of(const fs::path& out) {
    const Reported verification = reported(out);
    page::FigureBook book{.physics = {physics::all.begin(), physics::all.end()},
                          .studies = studies(verification),
                          .verification = verification.address,
                          .ledger = ledger(out / "figures" / "ledger.json")};
    for (const Entry& entry : catalogue()) {
        if (!entry.draw) continue;
        if (auto found = drawn(entry, out))
            book.cases.push_back(std::move(*found));
        else
            add_missing(book, entry, out);
    }
    if (!book.cases.empty()) book.options = options_of(book.cases.back().fidelity, out);
    return book;
}

}  // namespace

std::string opening_comment_of(const Entry& entry) {
    std::ifstream file(source_path(entry.source));
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return page::opening_comment(text);
}

std::optional<fs::path> write_figure_pages(const fs::path& out) {
    const page::FigureBook book = book_of(out);
    if (book.cases.empty() && book.movies.empty() && !book.ledger) return {};
    const fs::path figures = out / "figures";
    std::vector<std::string> pages;
    for (size_t k = 0; k < book.cases.size(); ++k) {
        pages.push_back(book.cases[k].name);
        write_file(figures / (pages.back() + ".html"), page::figure_page(book, k));
    }
    if (book.ledger) write_file(figures / "ledger.html", page::ledger_page(*book.ledger, pages));
    write_file(figures / "index.html", page::figure_index(book));
    return figures / "index.html";
}

}  // namespace crawford
