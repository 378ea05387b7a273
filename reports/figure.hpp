#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/scratch.hpp"
#include "reports/figure_data.hpp"

/// Figures: numbers go to CSV files, a gnuplot script of the case's own draws them in the house
/// style.
///
///     Figure("fig03", out, "cases/paper/fig03.gp")
///         .table("solver", {{"depth", "um", y}, {"temperature", "K", T}})
///         .set("surface_temperature", T.back())
///         .caption({.grid = "1 x 128", .step = "steady", .revision = revision})
///         .panel("a").panel("b")
///         .draw();
///
/// and in cases/paper/fig03.gp, which knows each table as data_<name>, each panel as panel_<name>,
/// and every set() variable:
///
///     @panel_a
///     plot data_solver using 1:2 with points title 'solver'
namespace crawford::reports {

/// gnuplot could not draw; what() names the figure and the script and carries gnuplot's own
/// message.
class FigureFailed : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

enum class Format {
    svg,  ///< For lines
    png,  ///< For maps
    gif,  ///< A movie, played again and again: every plot or multiplot of the panel is a frame
};

/// Size of a panel, in points of the style's type (11 to the text).
struct PanelSize {
    int width = 640;
    int height = 440;
};

/// What the small print under a figure must say. Empty entries are left out.
struct Caption {
    std::string grid = {};
    std::string step = {};
    std::string revision = {};
    std::string note = {};
};

class Figure {
public:
    /// Writes to `out`/figures. A relative script is found from the source tree, wherever the
    /// program is run.
    /// \throws std::invalid_argument if the name is not letters, digits and '_' only, as for every
    /// name below.
    Figure(const std::string& name, const std::filesystem::path& out,
           const std::filesystem::path& script);

    /// Numbers as CSV beside the figure, <figure>_<table>.csv.
    /// \throws std::invalid_argument if columns differ in length
    Figure& table(const std::string& name, const std::vector<Column>& columns);
    /// A field on sloped quads, likewise; for `splot data_<name> using 1:2:3` after
    /// @colours_<name>.
    Figure& map(const std::string& name, const QuadMap& quads);
    /// Writes what table() and map() are given from now on where it is gone with the figure: the
    /// frames of a movie.
    Figure& forget_numbers();
    /// A variable of the script.
    Figure& set(const std::string& name, double value);
    Figure& set(const std::string& name, const std::string& text);
    Figure& caption(const Caption& caption);
    /// Adds <figure><panel>.svg or .png, @panel_<panel> in the script.
    /// \throws std::invalid_argument if there is one of that name, or one without a name.
    Figure& panel(const std::string& name, Format format = Format::svg, PanelSize size = {});
    /// The only panel, <figure>.svg or .png and @panel in the script. Without any panel() it is
    /// there, as an SVG of the usual size.
    /// \throws std::invalid_argument if there is another.
    Figure& panel(Format format, PanelSize size = {});

    /// Runs gnuplot. All panels appear under their names together, or none does.
    /// \throws FigureFailed if gnuplot is missing or fails, finds a table without points, or draws
    /// no picture.
    std::vector<std::filesystem::path> draw() const;

    /// The numbers written so far and kept, as files.
    const std::vector<std::filesystem::path>& data() const { return data_; }

private:
    struct Panel {
        std::string name;  ///< empty if it is the only one
        Format format;
        PanelSize size;
    };
    Figure& add(const Panel& panel);
    std::string prelude(const std::vector<Panel>& panels,
                        const std::vector<std::filesystem::path>& outputs) const;
    std::filesystem::path file(const std::string& suffix) const;
    std::filesystem::path numbers(const std::string& table) const;

    std::string name_;
    std::filesystem::path directory_;
    std::filesystem::path script_;
    std::shared_ptr<const Scratch> scratch_;        // removed with the last who has it
    std::map<std::string, std::string> variables_;  // gnuplot name -> gnuplot expression
    std::vector<Panel> panels_;
    std::vector<std::filesystem::path> data_;
};

}  // namespace crawford::reports
