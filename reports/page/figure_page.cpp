#include <fmt/format.h>

#include <algorithm>

#include "reports/page/document.hpp"
#include "reports/page/figures.hpp"
#include "reports/page/ledger_claims.hpp"
#include "reports/page/manifest.hpp"
#include "reports/page/prose.hpp"
#include "reports/page/words.hpp"

namespace crawford::reports::page {
namespace {

std::string address_of(const DrawnCase& drawn) {
    return drawn.name + ".html";
}

/// To the case before and after, the index, the ledger and the studies.
Html links(const FigureBook& book, std::size_t index) {
    std::vector<std::pair<std::string, Html>> links;
    if (index > 0)
        links.emplace_back(address_of(book.cases[index - 1]),
                           "\u2190 " + label(book.cases[index - 1]));
    links.emplace_back("index.html", "all figures");
    if (book.ledger) links.emplace_back("ledger.html", "ledger");
    if (!book.verification.empty()) links.emplace_back(book.verification, "verification");
    if (index + 1 < book.cases.size())
        links.emplace_back(address_of(book.cases[index + 1]),
                           label(book.cases[index + 1]) + " \u2192");
    return navigation(links);
}

Html headline(const DrawnCase& drawn) {
    Html physics;
    for (const auto& heading : drawn.physics)
        physics += (physics.empty() ? "" : ", ") +
                   link_to("index.html#" + anchor_of_physics(heading), heading);
    return circumstances(drawn.manifest) +
           (physics.empty() ? Html() : styled("p", "facts", physics));
}

bool ends_with(const std::string& file, const char* extension) {
    return file.ends_with(extension);
}

Html picture(const DrawnCase& drawn, const std::string& file) {
    const Html shown =
        ends_with(file, ".mp4") || ends_with(file, ".webm")
            ? element("video", {{"src", file}, {"controls", "controls"}}, "")
            : link_to(file, element("img", {{"src", file}, {"alt", label(drawn) + ": " + file}}));
    return element("figure", {}, shown + element("figcaption", {}, link_to(file, file))) + "\n";
}

Html pictures(const DrawnCase& drawn) {
    Html all;
    for (const auto& file : drawn.pictures) all += picture(drawn, file);
    return styled("div", drawn.pictures.size() > 1 ? "pictures several" : "pictures", all) + "\n";
}

Html section(const std::string& id, const std::string& title, const Html& content) {
    if (content.empty()) return {};
    return element("section", {{"id", id}}, element("h2", {}, title) + content) + "\n";
}

Html findings(const DrawnCase& drawn) {
    Html rows;
    for (const auto& found : drawn.findings)
        rows +=
            element("tr", {},
                    element("td", {}, found.what) + styled("td", "count", number(found.value, 6)) +
                        element("td", {}, found.unit == "-" ? "" : found.unit)) +
            "\n";
    return rows.empty() ? rows : styled("table", "grounds", rows);
}

/// What of this the paper claims, and how it has turned out.
Html claims(const FigureBook& book, const DrawnCase& drawn) {
    if (!book.ledger) return {};
    const auto& all = book.ledger->rows;
    const auto anchors = anchors_of(all);
    Html rows;
    for (std::size_t k = 0; k < all.size(); ++k)
        if (all[k].entry == drawn.name)
            rows += row("td", {link_to("ledger.html#" + anchors[k], all[k].claim),
                               with_unit(all[k].paper, all[k].paper_value ? all[k].unit : ""),
                               ours(all[k]), mark(all[k].standing)});
    if (rows.empty()) return {};
    return styled("div", "wide",
                  styled("table", "grounds",
                         row("th", {"claim", "paper", "ours, in the ledger", "verdict"}) + rows));
}

Html data(const DrawnCase& drawn) {
    Html items;
    for (const auto& file : drawn.data) items += element("li", {}, link_to(file, file));
    return items.empty() ? items : element("ul", {}, items);
}

/// Heading by heading, the studies that verify it.
Html studies(const FigureBook& book, const DrawnCase& drawn) {
    Html rows;
    for (const auto& heading : drawn.physics) {
        Html names;
        for (const auto& study : book.studies)
            if (std::ranges::find(study.physics, heading) != study.physics.end())
                names += (names.empty() ? "" : " \u00b7 ") + link_to(study.address, study.name);
        if (!names.empty()) rows += row("td", {heading, names});
    }
    return rows.empty() ? rows : styled("table", "grounds", rows);
}

Html scenes(const DrawnCase& drawn) {
    Html all;
    for (std::size_t k = 0; k < drawn.scenes.size(); ++k)
        all += element("details", {},
                       element("summary", {},
                               fmt::format("Scene {} of {}", k + 1, drawn.scenes.size())) +
                           element("pre", {}, drawn.scenes[k])) +
               "\n";
    return all;
}

}  // namespace

std::string label(const DrawnCase& drawn) {
    return drawn.figure == "-" ? drawn.name : drawn.figure;
}

std::string figure_page(const FigureBook& book, std::size_t index) {
    const DrawnCase& drawn = book.cases.at(index);
    const std::string title = label(drawn) + ": " + drawn.shows;
    const Html text = prose(drawn.prose.empty() ? "# " + title : drawn.prose, "h1");
    const Html repeat = styled("p", "facts", element("code", {}, drawn.command)) +
                        styled("p", "facts", element("code", {}, drawn.source));
    return document(
        "Crawford: " + title,
        links(book, index) + text + headline(drawn) + pictures(drawn) +
            section("findings", "Findings", findings(drawn)) +
            section("claims", "What the paper claims", claims(book, drawn)) +
            section("data", "Numbers behind the pictures", data(drawn)) +
            section("repeat", "To draw it again", repeat) +
            section("studies", "Studies that verify what it rests on", studies(book, drawn)) +
            section("scenes", "Scenes", scenes(drawn)) + manifest(drawn.manifest));
}

}  // namespace crawford::reports::page
