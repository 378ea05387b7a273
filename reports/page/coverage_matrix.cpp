#include "reports/page/coverage_matrix.hpp"

#include "reports/page/overview.hpp"

namespace crawford::reports::page {
namespace {

Html head(const Coverage& coverage) {
    Html cells = element("th", {}, "term") + element("th", {}, "studies");
    for (const auto& study : coverage.studies())
        cells +=
            element("th", {{"class", "upright"}}, link(anchor_of_study(study.study), study.study));
    return element("thead", {}, element("tr", {}, cells)) + "\n";
}

Html term_row(const Coverage& coverage, const std::string& term) {
    const auto count = coverage.count(term);
    Html cells = element("th", {}, term) + element("td", {}, std::to_string(count));
    for (const auto& study : coverage.studies())
        cells += element("td", {}, study.covers(term) ? "\u25cf" : "");
    return element("tr", {{"class", count == 0 ? "fail" : ""}}, cells) + "\n";
}

}  // namespace

Html coverage_matrix(const Verification& v) {
    const auto coverage = v.coverage();
    Html rows = head(coverage);
    for (const auto& term : coverage.terms()) rows += term_row(coverage, term);
    return element("section", {{"id", "coverage"}},
                   element("h2", {}, "Coverage") +
                       element("p", {},
                               "A dot stands where a study would see a fault in a term of the "
                               "equations. A term that no study covers is red.") +
                       element("div", {{"class", "wide"}},
                               element("table", {{"class", "coverage"}}, rows))) +
           "\n";
}

}  // namespace crawford::reports::page
