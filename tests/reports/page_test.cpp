#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "reports/page/html.hpp"
#include "reports/page/plot.hpp"
#include "reports/page/prose.hpp"
#include "reports/page/report.hpp"
#include "reports/page/words.hpp"
#include "reports/study.hpp"

namespace crawford::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(HtmlText, IsEscapedWhereverItEnters) {
    const auto html = page::element("a", {{"href", "#\"x\""}}, "1 < 2 & \"so\" on");
    EXPECT_EQ(html.str(), "<a href=\"#&quot;x&quot;\">1 &lt; 2 &amp; &quot;so&quot; on</a>");
    EXPECT_EQ(page::element("p", {}, html + "<b>").str(), "<p>" + html.str() + "&lt;b&gt;</p>");
    EXPECT_EQ(page::anchor("study-", "slab, AP, 3 alpha K"), "study-slab-AP-3-alpha-K");
}

TEST(Words, AreShort) {
    EXPECT_EQ(page::number(1.2345e-5), "1.23e-5");
    EXPECT_EQ(page::number(0.95), "0.95");
    EXPECT_EQ(page::number(std::nan("")), "\u2013");
    EXPECT_EQ(page::percent_off(0.0419, 0.042), "-0.24 %");
    EXPECT_EQ(page::percent_off(3.42, 1.0), "+242 %");
    EXPECT_EQ(page::percent_off(6.6e-12, 1e-4), "6.6e-8 times") << "not -100 %";
    EXPECT_EQ(page::percent_off(-150.0, 10.0), "-1600 %");
    EXPECT_EQ(page::percent_off(150.0, 10.0), "15 times");
    EXPECT_EQ(page::with_unit("3", "K") + page::with_unit("4", "-"), "3 K4");
    EXPECT_EQ(page::labelled("T", "K") + page::labelled("n", ""), "T [K]n");
    EXPECT_EQ(page::duration(3.21), "3.2 s");
    EXPECT_EQ(page::duration(119.7), "2 min 0 s");
}

TEST(Prose, ReadsTheOpeningCommentOfACase) {
    const auto text = page::opening_comment(
        "/// # Bar: a < b?\n///\n/// One\n/// two `x`.\n"
        "///\n/// - first\n///   more\n/// - second\n\n"
        "#include <x>\n/// no page\n");
    EXPECT_EQ(page::prose(text).str(),
              "<h2>Bar: a &lt; b?</h2>\n<p>One two <code>x</code>.</p>\n"
              "<ul><li>first more</li><li>second</li></ul>\n");
    EXPECT_EQ(page::opening_comment("#include <x>\n"), "");
    EXPECT_TRUE(page::prose("").empty());
}

/// Errors of order one on four grids; the gates demand `order`.
Verification verified(double order) {
    Study study("rod, <thin>");
    study.refines("cells", {8, 16, 32, 64}).measure([](int n) {
        return Measurement(1.0 / n).error("T", Norm::L2, 1.0 / n).value("T_s", 1.0 + 1.0 / n);
    });
    study.gate("T", Norm::L2, expect(order).within(0.1).from(16), "h & no more")
        .bound("T_s", 64, between(0, 2), "any");
    Verification v;
    v.manifest = R"({"revision":"abc","wall_seconds":3.0,"machine":{"cores":2}})";
    v.whole = true;
    v.terms = {"heat", "stress"};
    v.studies = {{.name = "rod, <thin>",
                  .entry = "rod",
                  .page = "# Rod: how thin?\n",
                  .source = "cases/rod.cpp",
                  .command = "build/crawford verify rod",
                  .covers = {"heat"},
                  .grids = study.grids()}};
    v.gates = run(study);
    return v;
}

TEST(Plot, DrawsTheErrorsAndTheExpectedSlope) {
    const auto v = verified(1.0);
    const auto svg = page::order_plot(v.gates[0]).str();
    EXPECT_THAT(svg, HasSubstr("class=\"expected\""));
    EXPECT_THAT(svg, HasSubstr("measured hollow")) << "grid 8 is outside the fit";
    // Errors of the expected order lie on the slope: its ends are the ends of the measured line.
    const std::string n = "([0-9.]+)";
    const std::regex line("x1=\"" + n + "\" y1=\"" + n + "\" x2=\"" + n + "\" y2=\"" + n +
                          "\" class=\"expected\"");
    const std::regex ends("points=\"" + n + "," + n + " .* " + n + "," + n + " \"");
    std::smatch slope;
    std::smatch path;
    ASSERT_TRUE(std::regex_search(svg, slope, line));
    ASSERT_TRUE(std::regex_search(svg, path, ends));
    for (size_t k = 1; k <= 4; ++k) EXPECT_EQ(slope[k], path[k]);

    EXPECT_THAT(page::bound_plot(v.gates[1]).str(), HasSubstr("class=\"allowed\""));
    EXPECT_TRUE(page::order_plot(v.gates[1]).empty()) << "a bound has no errors";
    EXPECT_TRUE(page::bound_plot(GateResult{}).empty());
}

TEST(Report, ShowsEveryGateWithItsReasonAndCommand) {
    const auto html = page::report(verified(1.0));
    for (const char* part :
         {"<!DOCTYPE html>", "2 of 2 gates pass", "revision abc", "Rod: how thin?",
          "build/crawford verify rod", "h &amp; no more", "rod, &lt;thin&gt;", "order 1 \u00b1 0.1",
          "monotone", "prefers-color-scheme: dark", "@media print", "cases/rod.cpp"})
        EXPECT_THAT(html, HasSubstr(part));
}

TEST(Report, SaysOfItsManifestWhatCanBeUnderstood) {
    auto v = verified(1.0);
    for (const char* seconds : {"null", "[1]", "{}", "true"}) {
        v.manifest =
            std::string(R"({"revision":"abc","machine":3,"wall_seconds":)") + seconds + "}";
        EXPECT_THAT(page::report(v), HasSubstr("revision abc")) << seconds;
    }
}

TEST(Report, NeedsNothingFromOutside) {
    const auto html = page::report(verified(1.0));
    for (const char* part : {"<script", "http://", "https://", "src=", "@import", "url("})
        EXPECT_THAT(html, Not(HasSubstr(part)));
    const std::regex target("href=\"#([^\"]*)\"");
    for (std::sregex_iterator link(html.begin(), html.end(), target), end; link != end; ++link)
        EXPECT_THAT(html, HasSubstr("id=\"" + (*link)[1].str() + '"'));
    EXPECT_THAT(html, Not(testing::ContainsRegex("href=\"[^#]")));
}

TEST(Report, PutsFirstAndLinksWhatFellShort) {
    auto v = verified(2.0);
    const auto html = page::report(v);
    EXPECT_THAT(html, HasSubstr("fell short"));
    EXPECT_THAT(html,
                HasSubstr("<a href=\"#gate-1\">rod, &lt;thin&gt;: T, L2</a>: order 1.000 is"));
    EXPECT_THAT(html, HasSubstr("article id=\"gate-1\" class=\"gate fail\""));
    EXPECT_THAT(html, HasSubstr("no study covers &quot;stress&quot;"));
    EXPECT_THAT(html, HasSubstr("<tr class=\"fail\"><th>stress"));
    v.whole = false;
    EXPECT_THAT(page::report(v), Not(HasSubstr("no study covers"))) << "some were left out";
    v.gates[0].gated = false;
    EXPECT_THAT(page::report(v), HasSubstr("<span class=\"mark open\">not gated</span>"));
}

}  // namespace
}  // namespace crawford::reports
