/// HTML and SVG by nested calls. Plain text cannot become markup: it is escaped where it enters.
///
///     element("p", {{"class", "reason"}}, "error < 1 " + element("em", {}, "here"))
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace crawford::reports::page {

/// A piece of a page.
class Html {
public:
    Html() = default;
    // NOLINTBEGIN(google-explicit-constructor): text is welcome wherever markup is
    Html(std::string_view text);
    Html(const std::string& text) : Html(std::string_view(text)) {}
    Html(const char* text) : Html(std::string_view(text)) {}
    // NOLINTEND(google-explicit-constructor)

    /// Markup that has been written by hand.
    static Html markup(std::string_view written);

    Html& operator+=(const Html& more);
    const std::string& str() const { return markup_; }
    bool empty() const { return markup_.empty(); }

private:
    std::string markup_;
};

Html operator+(Html first, const Html& second);

using Attributes = std::vector<std::pair<std::string_view, std::string>>;

/// <tag attributes>content</tag>
Html element(std::string_view tag, const Attributes& attributes, const Html& content);

/// An element without content: <tag attributes/>
Html element(std::string_view tag, const Attributes& attributes);

/// A table row of cells `tag` ("td", "th"), of a class of style if one is named.
Html row(std::string_view tag, const std::vector<Html>& cells, const std::string& style = "");

/// A name that can be linked to: letters, digits and '-'.
std::string anchor(std::string_view prefix, std::string_view name);

/// A link within the page.
Html link(const std::string& anchor, const Html& text);

/// A link to another page; plain text if the address is empty.
Html link_to(const std::string& address, const Html& text);

/// Links to other pages, address and text, in one line.
Html navigation(const std::vector<std::pair<std::string, Html>>& links);

/// An element of a class of style.
Html styled(std::string_view tag, const std::string& style, const Html& content);

}  // namespace crawford::reports::page
