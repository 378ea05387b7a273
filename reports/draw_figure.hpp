/// From what a figure is made of to its pictures: gnuplot, in the house style.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "reports/figure_contents.hpp"

namespace crawford::reports {

/// gnuplot could not draw; what() names the figure and the script and carries gnuplot's own
/// message.
class FigureFailed : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Runs gnuplot on the tables that lie in `directory` and leaves the pictures there. All panels
/// appear under their names together, or none does.
/// \returns the pictures
/// \throws FigureFailed if gnuplot is missing or fails, finds a table without points, or draws no
/// picture; std::invalid_argument if a name or text is none that a script can hold.
std::vector<std::filesystem::path> draw(const FigureContents& contents,
                                        const std::filesystem::path& directory);

/// A gnuplot string literal in which nothing is special: single-quoted, the quote itself doubled.
/// \throws std::invalid_argument if there is a control character.
std::string quoted(const std::string& text);

}  // namespace crawford::reports
