// SPDX-License-Identifier: Apache-2.0
#include "desk/frame.hpp"

#include <fmt/format.h>

#include "base/markup.hpp"

namespace quadrat::desk {
namespace {

using base::escaped;

struct Link {
    const char* path;
    const char* key;
};
constexpr Link kPages[]{{"/", "nav.exhibit"},       {"/faults", "nav.faults"},   {"/log", "nav.log"},
                        {"/doctor", "nav.doctor"},  {"/report", "nav.visitors"}, {"/backup", "nav.backup"},
                        {"/curator", "nav.curator"}};

std::string name_of(const View& view) {
    return escaped(view.sources.exhibit.empty() ? "Quadrat" : view.sources.exhibit);
}

std::string header(const View& view) {
    std::string html = fmt::format("<header>\n<p class=\"name\">{}</p>\n", name_of(view));
    if (view.form_token.empty()) return html + "</header>\n";
    html += fmt::format("<nav aria-label=\"{}\">\n", escaped(view.say("nav")));
    for (const Link& link : kPages)
        html += fmt::format("<a href=\"{}\"{}>{}</a>\n", link.path,
                            view.path == link.path || view.path.starts_with(std::string(link.path) + "/")
                                ? " aria-current=\"page\""
                                : "",
                            escaped(view.say(link.key)));
    return html + "</nav>\n</header>\n";
}

std::string footer(const View& view) {
    std::string html = fmt::format("<footer>\n<nav aria-label=\"{}\">\n", escaped(view.say("nav.languages")));
    for (const Texts& language : languages())
        html +=
            fmt::format("<a href=\"{}?language={}\" lang=\"{}\" hreflang=\"{}\" dir=\"{}\"{}>{}</a>\n",
                        escaped(view.path), language.code(), language.code(), language.code(), language.direction(),
                        language.code() == view.say.code() ? " aria-current=\"true\"" : "", escaped(language.name()));
    html += "</nav>\n";
    if (!view.form_token.empty())
        html += fmt::format("<form method=\"post\" action=\"/logout\">{}<button class=\"quiet\">{}</button></form>\n",
                            token_field(view), escaped(view.say("logout")));
    return html +
           fmt::format("<p class=\"version\" dir=\"ltr\">quadrat {}</p>\n</footer>\n", escaped(view.sources.version));
}

}  // namespace

std::string page(const View& view, const std::string& key, const std::string& body) {
    const std::string title = escaped(view.say(key));
    std::string done;
    if (!view.done.empty()) done = fmt::format("<p class=\"done\" role=\"status\">{}</p>\n", escaped(view.done));
    return fmt::format(
        "<!doctype html>\n<html lang=\"{}\" dir=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{} · {}</title>\n"
        "<link rel=\"stylesheet\" href=\"/desk.css\">\n"
        "<script src=\"/desk.js\" defer></script>\n</head>\n<body>\n<a class=\"skip\" href=\"#content\">{}</a>\n"
        "{}<main id=\"content\">\n{}{}</main>\n{}</body>\n</html>\n",
        view.say.code(), view.say.direction(), title, name_of(view), escaped(view.say("nav.skip")), header(view), done,
        body, footer(view));
}

std::string token_field(const View& view) {
    return fmt::format("<input type=\"hidden\" name=\"token\" value=\"{}\">", view.form_token);
}

std::string act_button(const View& view, const std::string& act, const std::string& classes) {
    const std::string explained = fmt::format("act-{}", act);
    return fmt::format(
        "<form method=\"post\" action=\"/act\">{}<input type=\"hidden\" name=\"act\" value=\"{}\">"
        "<button{} aria-describedby=\"{}\">{}</button><small id=\"{}\">{}</small></form>\n",
        token_field(view), act, classes.empty() ? "" : fmt::format(" class=\"{}\"", classes), explained,
        escaped(view.say("act." + act)), explained, escaped(view.say("act." + act + ".explained")));
}

std::string program_words(const View& view, const std::string& words) {
    if (view.say.code() == "en" || words.empty()) return escaped(words);
    return fmt::format("<bdi lang=\"en\" dir=\"ltr\">{}</bdi>", escaped(words));
}

}  // namespace quadrat::desk
