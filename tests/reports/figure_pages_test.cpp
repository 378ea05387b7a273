/// The pages of the figures and of the ledger, made from plain data.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>
#include <string>

#include "reports/page/figures.hpp"
#include "reports/page/ledger.hpp"
#include "reports/page/ledger_claims.hpp"
#include "reports/page/ledger_grounds.hpp"
#include "reports/page/report.hpp"

namespace crawford::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

LedgerRow burn_rate() {
    return {.claim = "mean burn rate < 1",
            .where = "Fig. 15b",
            .entry = "fig15",
            .unit = "cm/s",
            .paper = "0.42",
            .ours = "0.416",
            .paper_value = 0.42,
            .value = 0.416,
            .uncertainty = {.grid = 0.003, .packs = 0.004},
            .reading = "as read",
            .standing = Standing::reproduced,
            .why = "Within 1 %."};
}

LedgerRow confined() {
    return {.claim = "stress is confined to AP",
            .where = "Fig. 7",
            .entry = "fig07",
            .unit = "-",
            .paper = "confined",
            .ours = "not confined",
            .standing = Standing::not_reproduced,
            .why = "It is not."};
}

Ledger some() {
    Ledger ledger;
    ledger.manifest = R"({"revision":"abc","fidelity":"paper"})";
    ledger.rows = {burn_rate(), confined()};
    return ledger;
}

/// A page without its style.
std::string body(const std::string& html) {
    return html.substr(html.find("<body>"));
}

/// Every link within the page leads to something in it.
void expect_links_lead_somewhere(const std::string& html) {
    const std::regex target("href=\"#([^\"]*)\"");
    for (std::sregex_iterator link(html.begin(), html.end(), target), end; link != end; ++link)
        EXPECT_THAT(html, HasSubstr("id=\"" + (*link)[1].str() + '"'));
}

TEST(LedgerPage, ShowsEveryClaimBesideOursWithItsUncertaintyAndVerdict) {
    const auto html = body(page::ledger_page(some(), {"fig15"}));
    for (const char* part :
         {"2 claims: 1 reproduced, 0 under another reading, 1 not", "mean burn rate &lt; 1",
          "0.42 cm/s", "0.416 \u00b1 0.005 cm/s", "grid 0.003; step not studied; packs 0.004",
          "-0.95 %", "mark pass\">reproduced", "mark fail\">not reproduced", "Within 1 %.",
          "revision abc", "<a href=\"fig15.html\">fig15</a>", "href=\"index.html\""})
        EXPECT_THAT(html, HasSubstr(part));
    EXPECT_THAT(html, Not(HasSubstr("href=\"fig07.html\""))) << "has no page";
    EXPECT_THAT(html, HasSubstr("<a href=\"#claim-Fig-7-stress-is-confined-to-AP\">stress is"))
        << "what is not reproduced is linked on top";
    expect_links_lead_somewhere(html);
}

TEST(LedgerPage, SaysWhatWasNotStudiedAndWhatCannotMatter) {
    Ledger ledger = some();
    ledger.rows[0].uncertainty = {};
    EXPECT_THAT(page::ledger_page(ledger, {}), HasSubstr("-0.95 %; uncertainty not studied"));
    ledger.rows[0].uncertainty = {.grid = 0.0};
    const auto closed = page::ledger_page(ledger, {});
    EXPECT_THAT(closed, HasSubstr("-0.95 %; no numerical uncertainty"));
    EXPECT_THAT(closed, Not(HasSubstr("\u00b1")));
    ledger.rows[0].value.reset();
    EXPECT_THAT(page::ledger_page(ledger, {}), Not(HasSubstr("uncertainty"))) << "words have none";
}

TEST(LedgerPage, GivesEachClaimAnAnchorOfItsOwnThatStays) {
    auto rows = some().rows;
    const auto before = page::anchors_of(rows);
    rows.insert(rows.begin(), confined());
    rows[0].claim = "new";
    rows.push_back(confined());
    const auto after = page::anchors_of(rows);
    EXPECT_EQ(after[1], before[0]);
    EXPECT_EQ(after[2], before[1]);
    EXPECT_EQ(after[3], before[1] + "-2");
}

TEST(Readings, MarkTheNearestOfThoseThatEnded) {
    const ReadingMatrix matrix{
        .title = "pack",
        .grid = "60 x 48",
        .quantities = {{"mean burn rate", "cm/s", 0.4}, {"peak", "-", {}}},
        .runs = {{.reading = "as read", .values = {0.44, 1.5}, .distance = 0.1},
                 {.reading = "alpha K", .set = {"a.b=1"}, .values = {0.42, 1.6}, .distance = 0.05},
                 {.reading = "c_v", .values = {nan, nan}, .distance = 0.0, .failure = "diverged"},
                 {.reading = "broken", .values = {nan, nan}, .distance = nan}}};
    const auto html = page::readings({matrix}).str();
    EXPECT_THAT(html, HasSubstr("alpha K <span class=\"mark pass\">nearest</span>"));
    EXPECT_THAT(html, HasSubstr("<code>a.b=1</code>"));
    EXPECT_THAT(html, HasSubstr("mean burn rate [cm/s]"));
    EXPECT_THAT(html, HasSubstr("<td>the paper</td><td>0.4</td><td>\u2013</td>"));
    EXPECT_THAT(html, HasSubstr("0.44<div class=\"facts\">+10 %</div>"));
    EXPECT_THAT(html, HasSubstr("<td>10 %</td>"));
    EXPECT_THAT(html, HasSubstr("diverged"));
    EXPECT_TRUE(page::readings({}).empty());
    const auto nearest = std::string("nearest</span>");
    EXPECT_EQ(html.find(nearest), html.rfind(nearest));
}

TEST(Refinements, StandInOneTableWhereTheirSizesAreTheSame) {
    Refinement rate{.quantity = "rate",
                    .of = "pack",
                    .direction = "x",
                    .unit = "cm/s",
                    .sizes = {8, 4, 2},
                    .size_unit = "um",
                    .values = {1.0, 1.2, 1.25},
                    .used = 4,
                    .order = 2.0,
                    .extrapolated = 1.2667,
                    .index = 0.0833,
                    .verdict = "monotone"};
    Refinement peak = rate;
    peak.quantity = "peak";
    peak.order.reset();
    Refinement step = rate;
    step.direction = "dt";
    const auto html = page::refinements({rate, peak, step}).str();
    EXPECT_THAT(html, HasSubstr("<th>8 um</th><th>4 um<div class=\"facts\">used</div></th>"));
    EXPECT_THAT(html, HasSubstr("<td>rate [cm/s]</td><td>1</td><td>1.2</td><td>1.25</td><td>2</td>"
                                "<td>1.2667</td><td>0.083</td><td>monotone</td>"));
    EXPECT_THAT(html, HasSubstr("<td>1.25</td><td>\u2013</td>"));
    const std::regex table("<table");
    EXPECT_EQ(std::distance(std::sregex_iterator(html.begin(), html.end(), table), {}), 2);
}

/// A damaged ledger may hold a null among the numbers.
TEST(Refinements, WhoseSizeIsNotKnownStandAlone) {
    Refinement rate{.quantity = "rate", .of = "pack", .sizes = {8}, .values = {1}};
    rate.used = nan;
    const auto html = page::refinements({rate, rate}).str();
    const std::regex table("<table");
    EXPECT_EQ(std::distance(std::sregex_iterator(html.begin(), html.end(), table), {}), 2);
}

TEST(Spreads, ShowEverySeed) {
    const auto html = page::spreads({{.quantity = "rate",
                                      .unit = "cm/s",
                                      .seeds = {3, 7},
                                      .values = {0.41, 0.43},
                                      .mean = 0.42,
                                      .deviation = 0.01414}})
                          .str();
    EXPECT_THAT(html, HasSubstr("<th>seed 3</th><th>seed 7</th>"));
    EXPECT_THAT(html, HasSubstr("<td>0.41</td><td>0.43</td><td>0.42</td><td>0.014</td>"));
}

page::FigureBook book() {
    page::FigureBook book{
        .physics = {"heat", "time step", "sandwich"},
        .cases = {{.name = "fig04", .figure = "Fig. 4", .shows = "slabs", .physics = {"heat"}},
                  {.name = "fig07",
                   .figure = "Fig. 7",
                   .shows = "maps of T & p",
                   .physics = {"heat", "sandwich"},
                   .prose = "# Figure 7: a sandwich\n\nWhat to trust.\n",
                   .source = "cases/paper/fig07.cpp",
                   .command = "build/crawford run fig07 --fidelity draft",
                   .fidelity = "draft",
                   .seconds = 8.0,
                   .pictures = {"fig07a.png", "fig07.mp4"},
                   .data = {"fig07_map.csv"},
                   .findings = {{"peak", 1.5, "MPa"}, {"order", nan, "-"}},
                   .scenes = {"title = \"s\"\n"},
                   .manifest = R"({"revision":"abc"})"},
                  {.name = "model", .figure = "-", .shows = "model form"}},
        .not_drawn = {"fig08"},
        .options = "--fidelity draft --out out/draft",
        .movies = {"fig08.gif"},
        .studies = {{.name = "slab",
                     .shows = "against the exact slab",
                     .physics = {"heat"},
                     .address = "../verify/report.html#entry-slab"},
                    {.name = "surface", .shows = "a front", .physics = {"burning"}}},
        .verification = "../verify/report.html"};
    book.ledger = some();
    return book;
}

TEST(FigurePage, ShowsTheCaseFromItsCommentToItsScenes) {
    const auto html = body(page::figure_page(book(), 1));
    for (const char* part :
         {"<h1>Figure 7: a sandwich</h1>", "What to trust.", "<img src=\"fig07a.png\"",
          "<video src=\"fig07.mp4\"", "<a href=\"fig07_map.csv\">", "<td>peak</td>", ">1.5</td>",
          ">\u2013</td>", "build/crawford run fig07 --fidelity draft", "cases/paper/fig07.cpp",
          "<summary>Scene 1 of 1</summary>", "title = &quot;s&quot;", "revision abc",
          "<a href=\"fig04.html\">\u2190 Fig. 4</a>", "<a href=\"model.html\">model \u2192</a>",
          "index.html#physics-sandwich", "../verify/report.html#entry-slab",
          "ledger.html#claim-Fig-7-stress-is-confined-to-AP", "not confined"})
        EXPECT_THAT(html, HasSubstr(part));
    EXPECT_THAT(html, Not(HasSubstr("mean burn rate"))) << "a claim of another case";
    EXPECT_THAT(html, Not(HasSubstr("surface"))) << "a study of other physics";
    expect_links_lead_somewhere(html);
}

TEST(FigurePage, LeavesOutWhatIsNotThere) {
    auto alone = book();
    alone.ledger.reset();
    alone.verification.clear();
    alone.cases = {alone.cases[2]};
    const auto html = body(page::figure_page(alone, 0));
    EXPECT_THAT(html, HasSubstr("<h1>model: model form</h1>"));
    for (const char* part : {"ledger", "verification", "Findings", "Numbers", "Scenes", "Studies"})
        EXPECT_THAT(html, Not(HasSubstr(part)));
}

TEST(FigureIndex, ListsFiguresByNumberAndFiguresWithStudiesByPhysics) {
    const auto html = body(page::figure_index(book()));
    for (const char* part :
         {"<img src=\"fig07a.png\"", "<td>maps of T &amp; p</td><td>draft</td>", "8.0 s",
          "<a href=\"model.html\">model</a>",
          "Not drawn: <code>build/crawford run fig08 --fidelity draft --out out/draft</code>",
          "Drawn as a movie: <a href=\"fig08.gif\">fig08.gif</a>", "1 of 2 claims", "<h3>heat</h3>",
          ("studies <span title=\"against the exact slab\">"
           "<a href=\"../verify/report.html#entry-slab\">"),
          "href=\"../verify/report.html\">verification"})
        EXPECT_THAT(html, HasSubstr(part));
    EXPECT_THAT(html, Not(HasSubstr("<h3>time step"))) << "nothing is there";
    const auto heat = html.find("id=\"physics-heat\"");
    const auto sandwich = html.find("id=\"physics-sandwich\"");
    EXPECT_LT(heat, sandwich);
    EXPECT_EQ(html.find("maps of T", sandwich), html.rfind("maps of T"));
    expect_links_lead_somewhere(html);
}

TEST(Report, LinksToTheFiguresIfThereAreAny) {
    EXPECT_THAT(page::report({}, "../figures/index.html"),
                HasSubstr("<a href=\"../figures/index.html\">figures</a>"));
    EXPECT_THAT(page::report({}), Not(HasSubstr("<nav>")));
}

}  // namespace
}  // namespace crawford::reports
