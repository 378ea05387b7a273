#include "reports/wrapped.hpp"

#include <sstream>

namespace crawford::reports {

std::string wrapped(const std::string& text, const std::string& indent, std::size_t width) {
    std::string lines, line;
    const std::size_t room = width - indent.size();
    const auto flush = [&] {
        if (!line.empty()) lines += indent + line + '\n';
        line.clear();
    };
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (!line.empty() && line.size() + 1 + word.size() > room) flush();
        for (; word.size() > room; word.erase(0, room))
            lines += indent + word.substr(0, room) + '\n';
        line += line.empty() ? word : ' ' + word;
    }
    flush();
    return lines;
}

}  // namespace crawford::reports
