#include "solver/files/history.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <string>

#include "base/atomic_file.hpp"
#include "base/errors.hpp"

namespace crawford {

namespace {

/// One line of the file: what `cell` gives for each column.
template <class Cell>
std::string line(const Cell& cell) {
    std::string text;
    for (const HistoryColumn& column : history_columns)
        text += fmt::format("{}{}", text.empty() ? "" : ",", cell(column));
    return text + '\n';
}

const std::string header = line([](const HistoryColumn& column) { return column.heading; });

/// The part of a history up to and including `time`.
std::string rows_until(const std::string& text, double time) {
    size_t begin = header.size();
    while (true) {
        const size_t end = text.find('\n', begin);
        if (end == std::string::npos) break;
        double row_time = 0.0;
        const auto [_, error] = std::from_chars(text.data() + begin, text.data() + end, row_time);
        if (error != std::errc() || row_time > time) break;
        begin = end + 1;
    }
    return text.substr(0, begin);
}

/// \throws InputError if it does not begin with the header.
std::string read_text(std::ifstream& file, const std::filesystem::path& path) {
    std::string text(std::istreambuf_iterator<char>(file), {});
    if (!text.starts_with(header))
        throw InputError(
            fmt::format("cannot go on with {}: it does not begin with the header of a "
                        "history; move it away or choose another directory",
                        path.string()));
    return text;
}

/// The numbers of a line; what is no number ends them.
std::vector<double> numbers(std::string_view line) {
    std::vector<double> found;
    const char* at = line.data();
    const char* const end = at + line.size();
    while (at < end) {
        double value = 0.0;
        const auto [after, error] = std::from_chars(at, end, value);
        if (error != std::errc()) break;
        found.push_back(value);
        at = after + 1;
    }
    return found;
}

}  // namespace

History::History(const std::filesystem::path& path)
    : path_(path), file_(path, std::ios::binary | std::ios::app) {
    if (!file_)
        throw InputError(fmt::format("cannot write {}: {}", path.string(), strerror(errno)));
}

History History::start(const std::filesystem::path& path) {
    write_file(path, header);
    return History(path);
}

History History::resume(const std::filesystem::path& path, double time) {
    std::ifstream old(path, std::ios::binary);
    if (!old) return start(path);
    write_file(path, rows_until(read_text(old, path), time));
    return History(path);
}

void History::append(const HistoryRow& row) {
    file_ << line([&](const HistoryColumn& column) { return row.*column.member; }) << std::flush;
    if (!file_)
        throw InputError(fmt::format("cannot write {}: {}", path_.string(), strerror(errno)));
}

std::vector<HistoryRow> read_history(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError(fmt::format("cannot read {}: {}", path.string(), strerror(errno)));
    const std::string text = read_text(file, path);
    std::vector<HistoryRow> rows;
    size_t begin = header.size();
    for (size_t end = text.find('\n', begin); end != std::string::npos;
         begin = end + 1, end = text.find('\n', begin)) {
        const auto n = numbers(std::string_view(text).substr(begin, end - begin));
        if (n.size() != history_columns.size())
            throw InputError(fmt::format("{}: row {} has {} numbers, not {}", path.string(),
                                         rows.size() + 1, n.size(), history_columns.size()));
        HistoryRow& row = rows.emplace_back();
        for (size_t k = 0; k < n.size(); ++k) row.*history_columns[k].member = n[k];
    }
    return rows;
}

}  // namespace crawford
