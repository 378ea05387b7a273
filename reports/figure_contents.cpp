#include "reports/figure_contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace crawford::reports {

std::string_view name(Format format) {
    switch (format) {
        case Format::svg:
            return "svg";
        case Format::png:
            return "png";
        default:
            return "gif";
    }
}

std::string_view name(Table::Kind kind) {
    switch (kind) {
        case Table::Kind::columns:
            return "columns";
        case Table::Kind::corner_map:
            return "corner map";
        case Table::Kind::cell_map:
            return "cell map";
        default:
            return "other";
    }
}

std::vector<Panel> FigureContents::all_panels() const {
    return panels.empty() ? std::vector<Panel>(1) : panels;
}

std::vector<std::filesystem::path> FigureContents::pictures() const {
    std::vector<std::filesystem::path> files;
    for (const Panel& panel : all_panels())
        files.emplace_back(fmt::format("{}{}.{}", name, panel.name, reports::name(panel.format)));
    return files;
}

std::vector<std::filesystem::path> FigureContents::data() const {
    std::vector<std::filesystem::path> files;
    for (const Table& table : tables)
        if (table.file.is_relative()) files.push_back(table.file);
    return files;
}

std::string checked_name(const std::string& name) {
    const auto fits = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_';
    };
    if (name.empty() || !std::ranges::all_of(name, fits))
        throw std::invalid_argument(
            fmt::format("figure: '{}' must be letters, digits and '_' only", name));
    return name;
}

}  // namespace crawford::reports
