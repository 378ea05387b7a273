#include "reports/page/report.hpp"

#include <fmt/format.h>

#include <iostream>

#include "cases/program/commands.hpp"
#include "reports/atomic_file.hpp"
#include "reports/verification.hpp"
#include "solver/errors.hpp"

namespace crawford {

namespace {

reports::Verification read(const std::filesystem::path& file) {
    try {
        return reports::read_verification(file);
    } catch (const std::runtime_error& problem) {
        throw InputError(fmt::format("{}; crawford verify --out {} writes it anew", problem.what(),
                                     file.parent_path().string()));
    }
}

}  // namespace

int report(const ReportOptions& options) {
    const auto page = options.out / "report.html";
    reports::write_atomically(page, reports::page::report(read(options.out / "verify.json")));
    std::cout << "report: " << page.string() << '\n';
    return exit_code::done;
}

}  // namespace crawford
