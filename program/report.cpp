#include "reports/page/report.hpp"

#include <fmt/format.h>

#include <iostream>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"
#include "program/commands.hpp"
#include "program/pages.hpp"
#include "reports/verification.hpp"

namespace crawford {

namespace {

namespace fs = std::filesystem;

reports::Verification read(const fs::path& file) {
    try {
        return reports::read_verification(file);
    } catch (const InputError& problem) {
        throw InputError(fmt::format("{}; crawford verify --out {} writes it anew", problem.what(),
                                     file.parent_path().string()));
    }
}

/// Where the index of figures lies, seen from `directory`; empty if there is none.
std::string address_of_figures(const fs::path& directory) {
    for (const char* address : {"../figures/index.html", "figures/index.html"})
        if (fs::exists(directory / address)) return address;
    return {};
}

/// Whether there was anything to report.
bool report_studies(const fs::path& directory) {
    const fs::path results = directory / "verify.json";
    if (!fs::exists(results)) return false;
    const fs::path page = directory / "report.html";
    write_file(page, reports::page::report(read(results), address_of_figures(directory)));
    std::cout << "report: " << page.string() << '\n';
    return true;
}

bool report_figures(const fs::path& out) {
    const auto index = write_figure_pages(out);
    if (index) std::cout << "figures: " << index->string() << '\n';
    return index.has_value();
}

}  // namespace

int report(const ReportOptions& options) {
    const bool figures = report_figures(options.out);  // first: the studies link to them
    const bool below = report_studies(options.out / "verify");
    const bool here = report_studies(options.out);
    if (!figures && !below && !here)
        throw InputError(
            fmt::format("{} holds no results: no figures, no verify/verify.json, no verify.json; "
                        "crawford run and crawford verify leave them",
                        options.out.string()));
    return exit_code::done;
}

}  // namespace crawford
