// SPDX-License-Identifier: Apache-2.0
#include "desk/curator_pages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/markup.hpp"
#include "desk/frame.hpp"

namespace quadrat::desk {
namespace {

using base::escaped;
using Kind = Entry::Kind;

std::string value_of(const Fields& fields, const std::string& name) {
    const auto found = fields.find(name);
    return found == fields.end() ? "" : found->second;
}

std::string speaks(const Entry& entry) {
    if (entry.language.empty()) return "";
    return fmt::format(" lang=\"{}\" dir=\"auto\"", escaped(entry.language));
}

// Draws one form's entries, with what was posted in the place of what holds.
class Drawer {
  public:
    Drawer(const View& view, const Posted& posted) : view_(view), posted_(posted) {}

    std::string group(const Group& group) const {
        std::string html = fmt::format("<section>\n<h2>{}</h2>\n", escaped(group.title));
        if (!group.hint.empty()) html += fmt::format("<p class=\"hint\">{}</p>\n", escaped(group.hint));
        const auto is_small = [](const Entry& entry) {
            return entry.kind == Kind::Tick || entry.kind == Kind::Range || entry.kind == Kind::Number ||
                   entry.kind == Kind::Day || !entry.picture.empty();
        };
        const bool is_dense = std::ranges::all_of(group.entries, is_small);
        html += fmt::format("<div class=\"entries{}\">\n", is_dense ? " dense" : "");
        for (const Entry& one : group.entries) html += entry(one);
        return html + "</div>\n</section>\n";
    }

  private:
    std::string now(const std::string& name, const std::string& value) const {
        return posted_.fields == nullptr ? value : value_of(*posted_.fields, name);
    }

    std::string entry(const Entry& entry) const {
        switch (entry.kind) {
            case Kind::Tick:
                return fmt::format(
                    "<label class=\"tick\"{}><input type=\"checkbox\" name=\"{}\" value=\"on\"{}> {}</label>\n",
                    speaks(entry), escaped(entry.name), now(entry.name, entry.value) == "on" ? " checked" : "",
                    escaped(entry.label));
            case Kind::Range:
                return range(entry);
            default:
                return fmt::format("<div class=\"entry\">\n{5}<label for=\"{0}\"{1}>{2}</label>\n{3}{4}</div>\n",
                                   escaped(entry.name), speaks(entry), escaped(entry.label), control(entry),
                                   below(entry), picture(entry));
        }
    }

    static std::string picture(const Entry& entry) {
        if (entry.picture.empty()) return "";
        return fmt::format("<img src=\"{}\" width=\"480\" height=\"270\" alt=\"{}\" loading=\"lazy\">\n",
                           escaped(entry.picture), escaped(entry.label));
    }

    std::string below(const Entry& entry) const {
        std::string html;
        if (!entry.download.empty())
            html +=
                fmt::format("<a href=\"{}\" download>{}</a>\n", escaped(entry.download), escaped(entry.download_label));
        if (!entry.hint.empty())
            html += fmt::format("<small id=\"{}-hint\">{}</small>\n", escaped(entry.name), escaped(entry.hint));
        if (entry.can_be_previewed)
            html += fmt::format(
                "<button class=\"quiet\" name=\"preview\" value=\"{}\" formaction=\"/curator/preview\" "
                "formnovalidate aria-label=\"{}: {}\">{}</button>\n",
                escaped(entry.name), escaped(view_.say("preview.show")), escaped(entry.label),
                escaped(view_.say("preview.show")));
        return html;
    }

    std::string attributes(const Entry& entry) const {
        std::string html = fmt::format(" id=\"{0}\" name=\"{0}\"", escaped(entry.name));
        if (!entry.hint.empty()) html += fmt::format(" aria-describedby=\"{}-hint\"", escaped(entry.name));
        if (!entry.standard.empty()) html += fmt::format(" placeholder=\"{}\"", escaped(entry.standard));
        if (!entry.language.empty()) html += speaks(entry);
        return html;
    }

    std::string control(const Entry& entry) const {
        const std::string value = now(entry.name, entry.value);
        switch (entry.kind) {
            case Kind::Lines:
                return fmt::format("<textarea rows=\"6\"{}>{}</textarea>\n", attributes(entry), escaped(value));
            case Kind::Number:
                return fmt::format("<input type=\"number\" min=\"{}\" max=\"{}\" step=\"any\"{} value=\"{}\">\n",
                                   entry.least, entry.most, attributes(entry), escaped(value));
            case Kind::Day:
                return fmt::format("<input type=\"date\"{} value=\"{}\">\n", attributes(entry), escaped(value));
            case Kind::Choice: {
                std::string html = fmt::format("<select{}>\n", attributes(entry));
                for (const Option& option : entry.options)
                    html += fmt::format("<option value=\"{}\"{}>{}</option>\n", escaped(option.value),
                                        option.value == value ? " selected" : "", escaped(option.label));
                return html + "</select>\n";
            }
            default:
                return fmt::format("<input{} value=\"{}\" autocomplete=\"off\">\n", attributes(entry), escaped(value));
        }
    }

    std::string range(const Entry& entry) const {
        const std::size_t space = std::min(entry.value.find(' '), entry.value.size());
        const std::string ends[]{entry.value.substr(0, space),
                                 entry.value.substr(std::min(space + 1, entry.value.size()))};
        std::string html =
            fmt::format("<fieldset class=\"range\">\n<legend{}>{}</legend>\n", speaks(entry), escaped(entry.label));
        const char* const names[]{"low", "high"};
        for (std::size_t i = 0; i < 2; ++i) {
            const std::string name = fmt::format("{}.{}", entry.name, names[i]);
            html += fmt::format(
                "<label>{} <input type=\"number\" min=\"{}\" max=\"{}\" step=\"any\" name=\"{}\" "
                "value=\"{}\"></label>\n",
                escaped(view_.say(fmt::format("range.{}", names[i]))), entry.least, entry.most, escaped(name),
                escaped(now(name, ends[i])));
        }
        return html + "</fieldset>\n";
    }

    const View& view_;
    const Posted& posted_;
};

std::string parts_of(const View& view) {
    std::string html = fmt::format("<nav class=\"parts\" aria-label=\"{}\">\n", escaped(view.say("curator.parts")));
    const auto link = [&](const std::string& path, const std::string& key) {
        html += fmt::format("<a href=\"{}\"{}>{}</a>\n", escaped(path),
                            view.path == path ? " aria-current=\"page\"" : "", escaped(view.say(key)));
    };
    link("/curator", "curator.overview");
    for (const std::string& part : view.sources.curator.parts()) link("/curator/" + part, "curator." + part);
    return html + "</nav>\n";
}

std::string previewed(const View& view, const Posted& posted) {
    if (posted.previewed.empty()) return "";
    return fmt::format(
        "<figure id=\"preview\">\n<img id=\"previewed\" src=\"/preview.png\" width=\"854\" height=\"480\" alt=\"{}\">\n"
        "<figcaption><span id=\"preview-state\" role=\"status\" data-drawn=\"{}\">{}</span>\n"
        "<noscript><a href=\"/preview.png\">{}</a></noscript></figcaption>\n</figure>\n",
        escaped(view.say("preview.alt")), escaped(view.say("preview.drawn")), escaped(view.say("preview.soon")),
        escaped(view.say("preview.look")));
}

}  // namespace

std::string curator_page(const View& view) {
    std::string body = parts_of(view) + fmt::format("<h1>{}</h1>\n<p>{}</p>\n", escaped(view.say("curator")),
                                                    escaped(view.say("curator.explained")));
    body += fmt::format("<h2>{}</h2>\n", escaped(view.say("curator.changes")));
    const std::vector<Change> changes = view.sources.curator.changes();
    if (changes.empty())
        return page(view, "curator", body + "<p>" + escaped(view.say("curator.changes.none")) + "</p>\n");
    body += fmt::format(
        "<form method=\"post\" action=\"/curator\">{}<button name=\"undo\" value=\"last\">{}</button></form>\n"
        "<ol class=\"changes\">\n",
        token_field(view), escaped(view.say("curator.undo")));
    for (const Change& change : changes) {
        const std::string& part = view.say("curator." + change.what);
        body += fmt::format("<li><time dir=\"ltr\">{}</time> <b>{}</b> <span dir=\"auto\">{}</span></li>\n",
                            escaped(change.at), escaped(part.empty() ? change.what : part), escaped(change.who));
    }
    return page(view, "curator", body + "</ol>\n");
}

std::string form_page(const View& view, const Form& form, const Posted& posted) {
    const std::string title = "curator." + form.part;
    std::string body = parts_of(view) + fmt::format("<h1>{}</h1>\n", escaped(view.say(title)));
    if (!posted.trouble.empty())
        body += fmt::format("<p class=\"lost\" role=\"alert\" id=\"trouble\">{} {}</p>\n",
                            escaped(view.say("curator.refused")), program_words(view, posted.trouble));
    if (!form.hint.empty()) body += fmt::format("<p>{}</p>\n", escaped(form.hint));
    if (!form.others.empty()) {
        body += fmt::format("<nav class=\"others\" aria-label=\"{}\">\n", escaped(view.say(title)));
        for (const Option& other : form.others)
            body += fmt::format("<a href=\"{}\" dir=\"auto\"{}>{}</a>\n", escaped(other.value),
                                other.value == form.current ? " aria-current=\"true\"" : "", escaped(other.label));
        body += "</nav>\n";
    }
    body += previewed(view, posted);
    body += fmt::format("<form class=\"curated\" method=\"post\" action=\"/curator/{}\">{}\n", escaped(form.part),
                        token_field(view));
    for (const auto& [name, value] : form.kept)
        body += fmt::format("<input type=\"hidden\" name=\"{}\" value=\"{}\">\n", escaped(name), escaped(value));
    // A line's Enter presses the first button of a form: it must be this one, not a preview.
    body += fmt::format("<button class=\"first\" tabindex=\"-1\" aria-hidden=\"true\">{}</button>\n",
                        escaped(view.say("curator.save")));
    const Drawer drawer(view, posted);
    for (const Group& group : form.groups) body += drawer.group(group);
    body +=
        fmt::format("<div class=\"row ends\"><button class=\"main\">{}</button>\n", escaped(view.say("curator.save")));
    if (!form.remove.empty())
        body += fmt::format("<button class=\"grave\" name=\"remove\" value=\"on\" formnovalidate>{}</button>\n",
                            escaped(form.remove));
    return page(view, title, body + "</div>\n</form>\n");
}

}  // namespace quadrat::desk
