#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/page/document.hpp"
#include "reports/page/figures.hpp"
#include "reports/page/words.hpp"

namespace crawford::reports::page {
namespace {

bool is_under(const std::vector<std::string>& headings, const std::string& heading) {
    return std::ranges::find(headings, heading) != headings.end();
}

/// The first picture that is none in motion.
Html thumbnail(const DrawnCase& drawn) {
    for (const auto& file : drawn.pictures)
        if (file.ends_with(".svg") || file.ends_with(".png"))
            return link_to(drawn.name + ".html", element("img", {{"src", file},
                                                                 {"alt", label(drawn)},
                                                                 {"loading", "lazy"},
                                                                 {"class", "thumbnail"}}));
    return {};
}

Html case_row(const DrawnCase& drawn) {
    return element("tr", {{"id", anchor("case-", drawn.name)}},
                   element("td", {}, thumbnail(drawn)) +
                       element("td", {}, link_to(drawn.name + ".html", label(drawn))) +
                       element("td", {}, drawn.shows) + element("td", {}, drawn.fidelity) +
                       styled("td", "count", drawn.seconds > 0.0 ? duration(drawn.seconds) : "")) +
           "\n";
}

Html by_figure(const FigureBook& book) {
    Html rows = element("thead", {}, row("th", {"", "figure", "shows", "fidelity", "cost"}));
    for (const auto& drawn : book.cases) rows += case_row(drawn);
    Html text = element("h2", {}, "By figure") + styled("table", "studies gallery", rows);
    if (!book.not_drawn.empty())
        text += element(
            "p", {},
            "Not drawn: " +
                element("code", {},
                        fmt::format("build/crawford run {}{}{}", fmt::join(book.not_drawn, " "),
                                    book.options.empty() ? "" : " ", book.options)));
    for (const auto& movie : book.movies)
        text += element("p", {}, "Drawn as a movie: " + link_to(movie, movie));
    return element("section", {{"id", "by-figure"}}, text) + "\n";
}

Html figures_under(const FigureBook& book, const std::string& heading) {
    Html items;
    for (const auto& drawn : book.cases)
        if (is_under(drawn.physics, heading))
            items += element("li", {},
                             link_to(drawn.name + ".html", label(drawn)) + " " +
                                 styled("span", "facts", drawn.shows));
    return items.empty() ? items : element("ul", {}, items);
}

Html studies_under(const FigureBook& book, const std::string& heading) {
    Html names;
    for (const auto& study : book.studies)
        if (is_under(study.physics, heading))
            names += (names.empty() ? "studies " : " \u00b7 ") +
                     element("span", {{"title", study.shows}}, link_to(study.address, study.name));
    return names.empty() ? names : styled("p", "facts", names);
}

Html by_physics(const FigureBook& book) {
    Html sections;
    for (const auto& heading : book.physics) {
        const Html content = figures_under(book, heading) + studies_under(book, heading);
        if (content.empty()) continue;
        sections += element("section", {{"id", anchor_of_physics(heading)}},
                            element("h3", {}, heading) + content) +
                    "\n";
    }
    return element("section", {{"id", "by-physics"}},
                   element("h2", {}, "By physics") + styled("div", "columns", sections)) +
           "\n";
}

Html claims(const Ledger& ledger) {
    const auto held = std::ranges::count(ledger.rows, Standing::reproduced, &LedgerRow::standing);
    return styled("p", "count-of-all",
                  link_to("ledger.html", "Ledger") +
                      fmt::format(": {} of {} claims reproduced as the paper is read here", held,
                                  ledger.rows.size()));
}

}  // namespace

std::string anchor_of_physics(const std::string& heading) {
    return anchor("physics-", heading);
}

std::string figure_index(const FigureBook& book) {
    std::vector<std::pair<std::string, Html>> links{{"#by-figure", "by figure"},
                                                    {"#by-physics", "by physics"}};
    if (book.ledger) links.emplace_back("ledger.html", "ledger");
    if (!book.verification.empty()) links.emplace_back(book.verification, "verification");
    return document("Crawford: figures", navigation(links) +
                                             element("h1", {}, "Crawford: figures of the paper") +
                                             (book.ledger ? claims(*book.ledger) : Html()) +
                                             by_figure(book) + by_physics(book));
}

}  // namespace crawford::reports::page
