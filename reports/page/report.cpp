#include "reports/page/report.hpp"

#include "reports/page/coverage_matrix.hpp"
#include "reports/page/manifest.hpp"
#include "reports/page/overview.hpp"
#include "reports/page/study_sections.hpp"
#include "reports/page/style.hpp"

namespace crawford::reports::page {

std::string report(const Verification& v) {
    const Html head =
        element("meta", {{"charset", "utf-8"}}) +
        element("meta",
                {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}}) +
        element("title", {}, "Crawford: verification") + element("style", {}, Html::markup(style));
    const Html body = headline(v) + table_of_studies(v) + coverage_matrix(v) + study_sections(v) +
                      manifest(v.manifest);
    return "<!DOCTYPE html>\n" +
           element(
               "html", {{"lang", "en"}},
               element("head", {}, head) + "\n" + element("body", {}, element("main", {}, body)))
               .str() +
           '\n';
}

}  // namespace crawford::reports::page
