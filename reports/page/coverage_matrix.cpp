#include "reports/page/coverage_matrix.hpp"

#include "reports/page/overview.hpp"

namespace crawford::reports::page {
namespace {

Html head(const Coverage& coverage) {
    Html cells = element("th", {}, "term") + element("th", {}, "studies");
    for (const auto& study : coverage.studies())
        cells +=
            element("th", {{"class", "upright"}}, link(anchor_of_entry(study.study), study.study));
    return element("thead", {}, element("tr", {}, cells)) + "\n";
}

/// Red where a term is uncovered, unless that is only because some studies were left out.
Html term_row(const Coverage& coverage, const std::string& term, bool whole) {
    const auto count = coverage.count(term);
    Html cells = element("th", {}, term) + element("td", {}, std::to_string(count));
    for (const auto& study : coverage.studies())
        cells += element("td", {}, study.covers(term) ? "\u25cf" : "");
    return element("tr", {{"class", count > 0 ? "" : whole ? "fail" : "aside"}}, cells) + "\n";
}

}  // namespace

Html coverage_matrix(const Verification& v) {
    const auto coverage = v.coverage();
    Html rows = head(coverage);
    for (const auto& term : coverage.terms()) rows += term_row(coverage, term, v.whole);
    return element("section", {{"id", "coverage"}},
                   element("h2", {}, "Coverage") +
                       element("p", {},
                               std::string("A dot stands where a study would see a fault in a term "
                                           "of the equations. ") +
                                   (v.whole ? "A term that no study covers is red."
                                            : "Not all studies have run in full.")) +
                       element("div", {{"class", "wide"}},
                               element("table", {{"class", "coverage"}}, rows))) +
           "\n";
}

}  // namespace crawford::reports::page
