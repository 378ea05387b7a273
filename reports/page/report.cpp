#include "reports/page/report.hpp"

#include "reports/page/coverage_matrix.hpp"
#include "reports/page/document.hpp"
#include "reports/page/manifest.hpp"
#include "reports/page/overview.hpp"
#include "reports/page/study_sections.hpp"

namespace crawford::reports::page {

std::string report(const Verification& v, const std::string& figures) {
    const Html to_figures = figures.empty() ? Html() : navigation({{figures, "figures"}});
    // Results of another code have no terms of ours to cover.
    const Html matrix = v.terms.empty() ? Html() : coverage_matrix(v);
    return document("Crawford: verification", to_figures + headline(v) + table_of_studies(v) +
                                                  matrix + study_sections(v) +
                                                  manifest(v.manifest));
}

}  // namespace crawford::reports::page
