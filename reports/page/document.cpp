#include "reports/page/document.hpp"

#include "reports/page/style.hpp"

namespace crawford::reports::page {

std::string document(const std::string& title, const Html& body) {
    const Html head = element("meta", {{"charset", "utf-8"}}) +
                      element("meta", {{"name", "viewport"},
                                       {"content", "width=device-width, initial-scale=1"}}) +
                      element("title", {}, title) + element("style", {}, Html::markup(style));
    return "<!DOCTYPE html>\n" +
           element(
               "html", {{"lang", "en"}},
               element("head", {}, head) + "\n" + element("body", {}, element("main", {}, body)))
               .str() +
           '\n';
}

}  // namespace crawford::reports::page
