/// Tables of comma-separated text: a header row, then rows with as many cells.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace crawford {

struct CsvRow {
    int line;  ///< of the file, from 1
    std::vector<std::string> cells;
};

struct CsvTable {
    std::filesystem::path file;
    int header_line;
    std::vector<std::string> header;
    std::vector<CsvRow> rows;  ///< each with as many cells as the header, none of them empty

    /// "FILE:LINE:", for messages.
    std::string place(int line) const;
};

/// Reads what spreadsheets and programs write: a byte order mark, quoted cells (RFC 4180) and any
/// line ends are understood; empty rows and rows that begin with # are passed over.
/// \throws InputError naming the file, and the line where there is one: no file, no header,
/// semicolons or tabs between the cells, a quote that is not closed, an empty cell, a row of
/// another length.
CsvTable read_csv(const std::filesystem::path& file);

/// The number in a cell, with a point for the decimals.
/// \throws InputError beginning with `place`, if it is none or not finite.
double csv_number(const std::string& cell, const std::string& place);

/// The cell that read_csv() reads as this text: quoted (RFC 4180) where a comma or a quote stands in it, a line
/// break turned into a blank.
std::string csv_cell(const std::string& text);

/// "radius [um]" taken apart; without brackets the unit is empty.
struct CsvHeading {
    std::string name, unit;
};
CsvHeading csv_heading(const std::string& heading);

}  // namespace crawford
