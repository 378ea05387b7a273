#include "reports/page/prose.hpp"

#include <sstream>
#include <vector>

namespace crawford::reports::page {
namespace {

/// Lines between blank ones.
std::vector<std::vector<std::string>> blocks_of(std::string_view text) {
    std::vector<std::vector<std::string>> blocks(1);
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);)
        if (!line.empty())
            blocks.back().push_back(line);
        else if (!blocks.back().empty())
            blocks.emplace_back();
    if (blocks.back().empty()) blocks.pop_back();
    return blocks;
}

/// Every second piece between backquotes is code.
Html with_code(const std::string& text) {
    Html html;
    bool code = false;
    for (std::size_t from = 0; from <= text.size();) {
        const auto to = std::min(text.find('`', from), text.size());
        const auto piece = text.substr(from, to - from);
        html += code ? element("code", {}, piece) : Html(piece);
        code = !code;
        from = to + 1;
    }
    return html;
}

std::string joined(const std::vector<std::string>& lines, const char* between) {
    std::string text;
    for (const auto& line : lines) text += (text.empty() ? "" : between) + line;
    return text;
}

Html list(const std::vector<std::string>& lines) {
    std::vector<std::string> items;
    for (const auto& line : lines)
        if (line.starts_with("- "))
            items.push_back(line.substr(2));
        else
            items.back() += ' ' + line.substr(line.find_first_not_of(' '));
    Html html;
    for (const auto& item : items) html += element("li", {}, with_code(item));
    return element("ul", {}, html);
}

Html block(const std::vector<std::string>& lines, std::string_view heading) {
    if (lines.front().starts_with("# "))
        return element(heading, {}, with_code(joined(lines, " ").substr(2)));
    if (lines.front().starts_with("- ")) return list(lines);
    if (lines.front().starts_with("    ")) return element("pre", {}, joined(lines, "\n"));
    return element("p", {}, with_code(joined(lines, " ")));
}

}  // namespace

std::string opening_comment(std::string_view source) {
    std::string text;
    std::istringstream lines{std::string(source)};
    for (std::string line; std::getline(lines, line) && line.starts_with("///");) {
        line.erase(0, line.starts_with("/// ") ? 4 : 3);
        text += line + '\n';
    }
    return text;
}

Html prose(std::string_view markdown, std::string_view heading) {
    Html html;
    for (const auto& lines : blocks_of(markdown)) html += block(lines, heading) + "\n";
    return html;
}

}  // namespace crawford::reports::page
