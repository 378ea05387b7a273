#include "program/judged_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <optional>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "program/point_file.hpp"
#include "program/read_tables.hpp"
#include "program/told_truth.hpp"

namespace crawford {

namespace {

/// What a file holds: a CSV file its table, a mesh its points and its cells.
using Tables = std::vector<CsvTable>;

std::map<int, Tables> tables(const std::vector<std::string>& files) {
    std::map<int, Tables> tables;
    for (const std::string& one : files) {
        const auto equals = one.find('=');
        int grid = 0;
        const auto [end, error] =
            std::from_chars(one.data(), one.data() + std::min(equals, one.size()), grid);
        if (equals == std::string::npos || error != std::errc() || end != one.data() + equals ||
            grid < 1)
            throw InputError(fmt::format(
                "{}: write GRID=FILE, the number of cells along the side that is refined and its "
                "results, e.g. 64=fields64.csv",
                one));
        if (!tables.emplace(grid, read_tables(one.substr(equals + 1))).second)
            throw InputError(fmt::format("{}: grid {} is given twice", one, grid));
    }
    return tables;
}

/// What people call them.
std::string full_name(const std::string& name) {
    static const std::map<std::string, std::string> short_names{{"T", "temperature"},
                                                                {"p", "pressure"}};
    const auto found = short_names.find(name);
    return found == short_names.end() ? name : found->second;
}

std::optional<reference::Field> field_named(const JudgeCase& one, const std::string& name) {
    const auto& fields = one.entry().fields;
    const auto found = std::ranges::find(fields, full_name(name), &reference::Field::name);
    if (found == fields.end()) return {};
    return *found;
}

MappedField mapped(const JudgeCase& one, const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals + 1 == text.size())
        throw InputError(fmt::format("--field {}: write NAME=COLUMN or NAME=COLUMN:UNIT", text));
    const std::string name = text.substr(0, equals);
    const auto field = field_named(one, name);
    if (!field) {
        std::vector<std::string> names;
        for (const auto& known : one.entry().fields) names.push_back(known.name);
        throw InputError(fmt::format("--field {}: {} has no field {}{}", text, one.truth, name,
                                     suggestion(name, names)));
    }
    const std::string rest = text.substr(equals + 1);
    const auto colon = rest.find(':');
    return {*field, rest.substr(0, colon),
            colon == std::string::npos ? "" : rest.substr(colon + 1)};
}

bool has_column(const CsvTable& table, const std::string& name) {
    return std::ranges::any_of(table.header, [&](const std::string& heading) {
        return csv_heading(heading).name == name;
    });
}

bool is_there(const std::vector<MappedField>& fields, const std::string& column) {
    return std::ranges::find(fields, column, &MappedField::column) != fields.end();
}

/// Every column that bears the name of a field; what points and cells both have, at points.
std::vector<MappedField> found_fields(const JudgeCase& one, const Tables& tables) {
    std::vector<MappedField> fields;
    for (const CsvTable& table : tables) {
        std::vector<MappedField> here;
        for (const std::string& heading : table.header) {
            const std::string name = csv_heading(heading).name;
            const auto field = field_named(one, name);
            if (field && !is_there(fields, name)) here.push_back({*field, name, ""});
        }
        fields.insert(fields.end(), here.begin(), here.end());
    }
    if (!fields.empty()) return fields;
    std::string known;
    for (const auto& field : one.entry().fields)
        known += fmt::format("{}{} [{}]", known.empty() ? "" : ", ", field.name, field.unit);
    throw InputError(
        fmt::format("{} has no field of {}; map one with --field NAME=COLUMN, NAME being one of {}",
                    tables.front().file.string(), one.truth, known));
}

std::vector<double> weights(const CsvTable& table) {
    for (const std::string& heading : table.header) {
        const auto [name, unit] = csv_heading(heading);
        if (name != "weight" && name != "area") continue;
        const auto column = csv_column(table, name);
        std::vector<double> values;
        for (const CsvRow& row : table.rows) {
            values.push_back(csv_number(row.cells[column], table.place(row.line)));
            if (values.back() <= 0.0)
                throw InputError(fmt::format("{} {} = {} must be above 0", table.place(row.line),
                                             heading, values.back()));
        }
        return values;
    }
    return {};
}

/// y of the highest point [m].
double highest_point(const CsvTable& table) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& point : csv_points(table)) highest = std::max(highest, point.y());
    return highest;
}

/// Compares the fields that this table has; y counts from `highest`.
void measure(const CsvTable& table, const reference::Truth& truth,
             const std::vector<MappedField>& fields, const WherePoints& where, double highest,
             reports::Measurement& found) {
    auto points = csv_points(table);
    for (Eigen::Vector2d& point : points) point.y() -= highest;
    const auto exact = told_values(truth, table, points, where.time);
    const auto sizes = weights(table);
    for (const auto& [field, column, unit] : fields) {
        const auto values = csv_quantities(table, csv_column(table, column), field.unit, unit);
        const auto truths = exact.column(field.name);
        found.field(field.name, values, truths, sizes);
        found.value("|" + field.name + " - truth|, largest",
                    distance(reports::Norm::Linf, values, truths, sizes));
    }
}

reports::Measurement measured(int grid, const Tables& tables, const reference::Truth& truth,
                              const std::vector<MappedField>& fields, const WherePoints& where) {
    reports::Measurement found(1.0 / grid);
    const double highest = where.from_surface ? highest_point(tables.front()) : 0.0;
    std::vector<MappedField> to_find = fields;
    for (const CsvTable& table : tables) {
        // The last answers for what is nowhere: it names the nearest heading.
        const bool is_last = &table == &tables.back();
        std::vector<MappedField> here, elsewhere;
        for (const MappedField& field : to_find)
            (is_last || has_column(table, field.column) ? here : elsewhere).push_back(field);
        if (!here.empty()) measure(table, truth, here, where, highest, found);
        to_find = std::move(elsewhere);
    }
    return found;
}

}  // namespace

JudgedFiles judged_files(const JudgeCase& one, const reference::Truth& truth,
                         const std::vector<std::string>& files,
                         const std::vector<std::string>& fields, const WherePoints& where) {
    const auto read = tables(files);
    if (read.empty())
        throw InputError(fmt::format(
            "judge {}: no GRID=FILE is given; --describe says what to solve", one.name));
    JudgedFiles judged;
    for (const std::string& text : fields) judged.fields.push_back(mapped(one, text));
    if (fields.empty()) judged.fields = found_fields(one, read.begin()->second);
    for (std::size_t k = 0; k < judged.fields.size(); ++k)
        for (std::size_t i = 0; i < k; ++i)
            if (judged.fields[i].field.name == judged.fields[k].field.name)
                throw InputError(fmt::format("{} is given twice", judged.fields[k].field.name));
    for (const auto& [grid, table] : read)
        judged.runs.push_back({grid, measured(grid, table, truth, judged.fields, where), "", 0.0});
    return judged;
}

}  // namespace crawford
