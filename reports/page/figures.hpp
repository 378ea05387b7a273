/// The pages of the figures that have been drawn, one a case, and their index. They lie beside the
/// pictures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/ledger.hpp"

namespace crawford::reports::page {

/// A number that a case has found.
struct FoundNumber {
    std::string what = {};
    double value = 0.0;
    std::string unit = {};
};

/// A case that has been drawn.
struct DrawnCase {
    std::string name = {};    ///< Its page is <name>.html
    std::string figure = {};  ///< "Fig. 3"; "-" if the paper has none
    std::string shows = {};
    std::vector<std::string> physics = {};  ///< Headings of FigureBook::physics
    std::string prose = {};                 ///< The opening comment of its file, Markdown
    std::string source = {};                ///< That file
    std::string command = {};               ///< Repeats it
    std::string fidelity = {};
    double seconds = 0.0;  ///< What it costs at this fidelity; 0 if that is not known
    std::vector<std::string> pictures = {};  ///< Files beside the page
    std::vector<std::string> data = {};      ///< Likewise, the numbers behind them
    std::vector<FoundNumber> findings = {};
    std::vector<std::string> scenes = {};  ///< TOML
    std::string manifest = "{}";           ///< What else is known of the run: a JSON object as text
};

/// Studies of the catalogue that verify what the figures rest on.
struct VerifyingStudy {
    std::string name = {};
    std::string shows = {};
    std::vector<std::string> physics = {};
    std::string address = {};  ///< Where it is reported; empty if it is not
};

struct FigureBook {
    std::vector<std::string> physics = {};    ///< All headings
    std::vector<DrawnCase> cases = {};        ///< In the order of the book
    std::vector<std::string> not_drawn = {};  ///< Names of the cases that have not been
    std::string options = {};                 ///< With which the others were: "--fidelity draft"
    std::vector<std::string> movies = {};     ///< Files beside the page, of cases not drawn
    std::vector<VerifyingStudy> studies = {};
    std::string verification =
        {};  ///< Address of the report of the studies; empty if there is none
    std::optional<Ledger> ledger = {};  ///< Its page is ledger.html
};

/// The page of the `index`th case.
std::string figure_page(const FigureBook& book, std::size_t index);

/// All cases by figure, then cases and studies by physics.
std::string figure_index(const FigureBook& book);

/// Where a heading of physics stands in the index.
std::string anchor_of_physics(const std::string& heading);

/// The figure's number in the paper, else the name of the case.
std::string label(const DrawnCase& drawn);

}  // namespace crawford::reports::page
