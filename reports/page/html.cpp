#include "reports/page/html.hpp"

#include <fmt/format.h>

#include <cctype>

namespace crawford::reports::page {
namespace {

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char c : text) switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            default:
                safe += c;
        }
    return safe;
}

std::string opening(std::string_view tag, const Attributes& attributes) {
    std::string text = fmt::format("<{}", tag);
    for (const auto& [name, value] : attributes)
        text += fmt::format(" {}=\"{}\"", name, escaped(value));
    return text;
}

}  // namespace

Html::Html(std::string_view text) : markup_(escaped(text)) {}

Html Html::markup(std::string_view written) {
    Html html;
    html.markup_ = written;
    return html;
}

Html& Html::operator+=(const Html& more) {
    markup_ += more.markup_;
    return *this;
}

Html operator+(Html first, const Html& second) {
    return std::move(first += second);
}

Html element(std::string_view tag, const Attributes& attributes, const Html& content) {
    return Html::markup(opening(tag, attributes) + '>' + content.str() + "</" + std::string(tag) +
                        ">");
}

Html element(std::string_view tag, const Attributes& attributes) {
    return Html::markup(opening(tag, attributes) + "/>");
}

Html row(std::string_view tag, const std::vector<Html>& cells, const std::string& style) {
    Html content;
    for (const auto& cell : cells) content += element(tag, {}, cell);
    const Attributes attributes = style.empty() ? Attributes{} : Attributes{{"class", style}};
    return element("tr", attributes, content) + "\n";
}

std::string anchor(std::string_view prefix, std::string_view name) {
    std::string text(prefix);
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c)))
            text += c;
        else if (text.back() != '-')
            text += '-';
    return text;
}

Html link(const std::string& anchor, const Html& text) {
    return link_to("#" + anchor, text);
}

Html link_to(const std::string& address, const Html& text) {
    return address.empty() ? text : element("a", {{"href", address}}, text);
}

Html navigation(const std::vector<std::pair<std::string, Html>>& links) {
    Html line;
    for (const auto& [address, text] : links)
        line += (line.empty() ? "" : " \u00b7 ") + link_to(address, text);
    return element("nav", {}, line) + "\n";
}

Html styled(std::string_view tag, const std::string& style, const Html& content) {
    return element(tag, {{"class", style}}, content);
}

}  // namespace crawford::reports::page
