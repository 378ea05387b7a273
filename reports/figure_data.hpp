/// Tables and maps that a figure is drawn from.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace crawford::reports {

/// One column of a table: its header reads "name [unit]".
struct Column {
    std::string name;
    std::string unit;  ///< "-" if there is none
    std::vector<double> values;
};

/// Comma-separated text with a header row; numbers with every digit that they have, NaN as "nan".
/// \throws std::invalid_argument if there is no column, if lengths differ, or if a header holds a
/// comma or line break.
std::string csv(const std::vector<Column>& columns);

/// A field over a sheet of quadrilaterals, such as a surface-following grid. Corners are
/// (columns+1) x (rows+1), the column index running fastest; values stand at all corners, or at the
/// cells (columns x rows).
struct QuadMap {
    std::size_t columns, rows;
    Column x, y;                 ///< Corners
    std::vector<Column> fields;  ///< Each at corners or each at cells

    bool at_cells() const;
};

/// As csv(), one scan line per row of corners and a blank line after each, as gnuplot's pm3d reads
/// it. Cell values stand at the corner with the lowest indices of the cell; the last row and column
/// repeat their neighbour's.
/// \throws std::invalid_argument \see csv, or if the number of values fits neither corners nor
/// cells.
std::string csv(const QuadMap& map);

}  // namespace crawford::reports
