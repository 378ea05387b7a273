/// Anyone's table of errors or values over several grids.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/csv_table.hpp"

namespace crawford::reports {

/// A column of the table.
struct OrderColumn {
    std::string name;
    bool is_error;  ///< falls to zero; else a value whose limit is not known
    std::vector<double> values;
};

/// Rows sorted by falling h.
struct OrderTable {
    std::string name;                  ///< file name without its ending
    std::string size_name;             ///< heading of the first column: "h [mm]", "cells"
    std::vector<double> sizes;         ///< that column
    std::vector<double> h;             ///< cell size: the first column, or cells^(-1/dimension)
    std::vector<int> grids;            ///< cells where they are whole, else 1, 2, ...
    std::vector<OrderColumn> columns;  ///< the others

    /// Whether the first column counts cells.
    bool counts_cells() const { return size_name == "cells"; }
    /// The grid of a size of the first column.
    /// \throws InputError naming the option, where the table has no such grid.
    int grid_of(double size, const std::string& option) const;
};

/// The first column is `h`, `h [unit]` or `cells` (then h = cells^(-1/dimension)), rows in any
/// order; a name that begins with "error" is an error.
/// \throws InputError naming file and line: another first column, a heading twice, no quantity,
/// fewer than two grids, a size that is not positive or stands twice; \see csv_number
OrderTable order_table(const CsvTable& csv, int dimension);

}  // namespace crawford::reports
