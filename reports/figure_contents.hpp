/// All that a figure is drawn from, as plain data: what a case fills, a record keeps and
/// draw_figure.hpp takes.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace crawford::reports {

enum class Format {
    svg,  ///< For lines
    png,  ///< For maps
    gif,  ///< A movie, played again and again: every plot or multiplot of the panel is a frame
};

/// "svg", "png", "gif": also the extension of its files.
std::string_view name(Format format);

/// Size of a panel, in points of the style's type (11 to the text).
struct PanelSize {
    int width = 640;
    int height = 440;

    bool operator==(const PanelSize&) const = default;
};

struct Panel {
    std::string name = {};  ///< empty if it is the only one
    Format format = Format::svg;
    PanelSize size = {};

    bool operator==(const Panel&) const = default;
};

/// Numbers in a file: what the script knows as data_<name>.
struct Table {
    /// Columns, or a field on quadrilaterals with values at corners or cells; or a file for other
    /// programs, which the script does not read.
    enum class Kind { columns, corner_map, cell_map, other };

    std::string name;
    Kind kind = Kind::columns;
    /// Below the directory of the figure. Absolute if it is gone with the figure.
    std::filesystem::path file;

    bool operator==(const Table&) const = default;
};

/// "columns", "corner map", "cell map", "other".
std::string_view name(Table::Kind kind);

struct FigureContents {
    std::string name;
    std::filesystem::path script;  ///< below the source tree, or absolute
    std::vector<Table> tables = {};
    /// Of the script, besides what it knows of tables and panels.
    std::map<std::string, std::variant<double, std::string>> variables = {};
    std::string caption = {};
    std::vector<Panel> panels = {};  ///< none: one SVG of the usual size
    bool keeps_numbers = true;       ///< whether all tables stay when the figure is drawn

    /// Those to be drawn: at least one.
    std::vector<Panel> all_panels() const;
    /// Names of the files: of the pictures, and of the numbers that are kept.
    std::vector<std::filesystem::path> pictures() const;
    std::vector<std::filesystem::path> data() const;

    bool operator==(const FigureContents&) const = default;
};

/// What may be a name in a script: letters, digits and '_' only.
/// \returns the name
/// \throws std::invalid_argument otherwise
std::string checked_name(const std::string& name);

}  // namespace crawford::reports
