/// Figures: numbers go to CSV files, a gnuplot script of the case's own draws them in the house
/// style.
///
///     Figure("fig03", out)
///         .table("solver", {{"depth", "um", y}, {"temperature", "K", T}})
///         .set("surface_temperature", T.back())
///         .caption({.grid = "1 x 128", .step = "steady", .revision = revision})
///         .panel("a").panel("b")
///         .draw();
///
/// and beside the case, in fig03.gp, which knows each table as data_<name>, each panel as
/// panel_<name>, and every set() variable:
///
///     @panel_a
///     plot data_solver using 1:2 with points title 'solver'
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/scratch.hpp"
#include "reports/draw_figure.hpp"
#include "reports/figure_data.hpp"

namespace crawford::reports {

/// What the small print under a figure must say. Empty entries are left out.
struct Caption {
    std::string grid = {};
    std::string step = {};
    std::string revision = {};
    std::string note = {};
};

/// The gnuplot script of a source file, beside it and named as it is.
std::filesystem::path script_of(const std::filesystem::path& source);

/// Fills a FigureContents and writes its numbers.
class Figure {
public:
    /// Writes to `out`/figures. The script is that of the file which calls this, if none is named;
    /// a relative one is found from the source tree, wherever the program is run.
    /// \throws std::invalid_argument if the name is not letters, digits and '_' only, as for every
    /// name below.
    Figure(const std::string& name, const std::filesystem::path& out,
           const std::filesystem::path& script = script_of(__builtin_FILE()));

    /// Numbers as CSV beside the figure, <figure>_<table>.csv.
    /// \throws std::invalid_argument if columns differ in length
    Figure& table(const std::string& name, const std::vector<Column>& columns);
    /// A field on sloped quads, likewise; for `splot data_<name> using 1:2:3` after
    /// @colours_<name>.
    Figure& map(const std::string& name, const QuadMap& quads);
    /// A file for other programs, listed with the numbers; `file` is below the figure's directory
    /// or leads out of it.
    Figure& other(const std::string& name, const std::filesystem::path& file,
                  const std::string& text);
    /// Writes what table() and map() are given from now on where it is gone with the figure: the
    /// frames of a movie.
    Figure& forget_numbers();
    /// A variable of the script.
    Figure& set(const std::string& name, double value);
    /// \throws std::invalid_argument if there is a control character in the text.
    Figure& set(const std::string& name, const std::string& text);
    Figure& caption(const Caption& caption);
    /// Adds <figure><panel>.svg or .png, @panel_<panel> in the script.
    /// \throws std::invalid_argument if there is one of that name, or one without a name.
    Figure& panel(const std::string& name, Format format = Format::svg, PanelSize size = {});
    /// The only panel, <figure>.svg or .png and @panel in the script. Without any panel() it is
    /// there, as an SVG of the usual size.
    /// \throws std::invalid_argument if there is another.
    Figure& panel(Format format, PanelSize size = {});

    /// \returns the pictures.
    /// \throws as reports::draw
    std::vector<std::filesystem::path> draw() const;

    const FigureContents& contents() const { return contents_; }

private:
    Figure& add(const Panel& panel);
    Figure& add(const std::string& table, Table::Kind kind, const std::string& numbers);

    FigureContents contents_;
    std::filesystem::path directory_;
    std::shared_ptr<const Scratch> scratch_;  // removed with the last who has it
};

}  // namespace crawford::reports
