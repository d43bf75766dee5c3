// SPDX-License-Identifier: Apache-2.0
#include "desk/pages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/markup.hpp"
#include "desk/frame.hpp"

namespace quadrat::desk {
namespace {

using base::escaped;

std::string title(const View& view, const char* key) { return fmt::format("<h1>{}</h1>\n", escaped(view.say(key))); }

// Lines as a terminal shows them. Whoever has no mouse scrolls it too.
std::string lines_of(const View& view, const std::vector<std::string>& lines, const char* key) {
    if (lines.empty()) return fmt::format("<p class=\"hint\">{}</p>\n", escaped(view.say("log.none")));
    std::string html = fmt::format("<pre tabindex=\"0\" role=\"region\" aria-label=\"{}\" lang=\"en\" dir=\"ltr\">",
                                   escaped(view.say(key)));
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) html += escaped(*line) + "\n";
    return html + "</pre>\n";
}

std::string bytes_text(const View& view, const std::optional<std::uint64_t>& bytes) {
    return escaped(bytes ? view.say("restore.bytes", {std::to_string(*bytes)}) : view.say("restore.missing"));
}

std::string preview_of(const View& view, const Preview& preview) {
    std::string html =
        fmt::format("<section class=\"preview\">\n<h2>{}</h2>\n<dl>\n", escaped(view.say("restore.preview")));
    const std::pair<const char*, std::string> facts[]{
        {"restore.made", preview.made_at}, {"restore.host", preview.host}, {"restore.program", preview.program}};
    for (const auto& [key, value] : facts)
        html += fmt::format("<div><dt>{}</dt><dd dir=\"auto\">{}</dd></div>\n", escaped(view.say(key)), escaped(value));
    html += fmt::format(
        "</dl>\n<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">\n<table>\n"
        "<thead><tr><th scope=\"col\">{}</th><th scope=\"col\">{}</th><th scope=\"col\">{}</th></tr>"
        "</thead>\n<tbody>\n",
        escaped(view.say("restore.preview")), escaped(view.say("restore.name")), escaped(view.say("restore.here")),
        escaped(view.say("restore.there")));
    for (const Preview::File& file : preview.files)
        html += fmt::format("<tr><th scope=\"row\" dir=\"ltr\">{}</th><td>{}</td><td>{}</td></tr>\n",
                            escaped(file.name), bytes_text(view, file.here), bytes_text(view, file.there));
    html += fmt::format("</tbody>\n</table>\n</div>\n<p>{}</p>\n", escaped(view.say("restore.kept")));
    html += fmt::format(
        "<form method=\"post\" action=\"/act\" class=\"stack\">{}<fieldset><legend>{}</legend>\n"
        "<label><input type=\"radio\" name=\"who\" value=\"same\" checked> {}</label>\n"
        "<label><input type=\"radio\" name=\"who\" value=\"clone\"> {}</label>\n</fieldset>\n"
        "<div class=\"row\"><button name=\"act\" value=\"drop\">{}</button>\n"
        "<button name=\"act\" value=\"restore\" class=\"grave\">{}</button></div>\n</form>\n</section>\n",
        token_field(view), escaped(view.say("restore.who")), escaped(view.say("restore.same")),
        escaped(view.say("restore.clone")), escaped(view.say("restore.drop")), escaped(view.say("restore.confirm")));
    return html;
}

}  // namespace

std::string login_page(const View& view, const std::string& trouble) {
    const std::string told =
        trouble.empty() ? "" : fmt::format("<p id=\"trouble\" class=\"bad\" role=\"alert\">{}</p>\n", escaped(trouble));
    return page(view, "login.title",
                title(view, "login.title") +
                    fmt::format("<form class=\"stack\" method=\"post\" action=\"/login\">\n{}"
                                "<label for=\"passphrase\">{}</label>\n"
                                "<input id=\"passphrase\" name=\"passphrase\" type=\"password\" maxlength=\"256\" "
                                "required autofocus autocomplete=\"current-password\"{}>\n<button>{}</button>\n"
                                "</form>\n",
                                told, escaped(view.say("login.label")),
                                trouble.empty() ? "" : " aria-describedby=\"trouble\" aria-invalid=\"true\"",
                                escaped(view.say("login.title"))));
}

std::string faults_page(const View& view, const std::vector<Fault>& faults) {
    std::string body = title(view, "faults");
    if (faults.empty()) return page(view, "faults", body + "<p>" + escaped(view.say("faults.none")) + "</p>\n");
    body += "<ol class=\"faults\">\n";
    for (const Fault& fault : faults) {
        body += fmt::format("<li>\n<p><time dir=\"ltr\">{}</time> {}</p>\n", escaped(fault.first),
                            program_words(view, fault.text));
        if (fault.count > 1)
            body += fmt::format("<p class=\"hint\">{}</p>\n",
                                escaped(view.say("faults.often", {std::to_string(fault.count), fault.last})));
        if (!fault.picture.empty())
            body += fmt::format(
                "<a href=\"/faults/{0}\"><img src=\"/faults/{0}\" width=\"320\" height=\"180\" loading=\"lazy\" "
                "alt=\"{1}\"></a>\n",
                escaped(fault.picture), escaped(view.say("faults.picture")));
        body += "</li>\n";
    }
    return page(view, "faults", body + "</ol>\n");
}

std::string log_page(const View& view, const std::vector<std::string>& lines, const std::vector<std::string>& notes) {
    std::string body = title(view, "log");
    if (!lines.empty())
        body += fmt::format("<p class=\"hint\">{}</p>\n",
                            escaped(view.say("log.explained", {std::to_string(lines.size())})));
    body += lines_of(view, lines, "log");
    body += fmt::format("<h2>{}</h2>\n", escaped(view.say("log.desk")));
    return page(view, "log", body + lines_of(view, notes, "log.desk"));
}

std::string doctor_page(const View& view, const std::vector<Finding>& found) {
    std::string body = title(view, "doctor") + "<ul class=\"findings\">\n";
    std::vector<Finding> findings = found;
    const auto ease = [](const Finding& one) { return one.verdict == "bad" ? 0 : one.verdict == "doubtful" ? 1 : 2; };
    std::ranges::stable_sort(findings, {}, ease);
    for (const Finding& finding : findings) {
        const std::string& word = view.say("doctor." + finding.verdict);
        body += fmt::format(
            "<li class=\"{}\"><p><b>{}</b> <span class=\"word\">{}</span></p>\n<p>{}</p>\n{}</li>\n",
            escaped(finding.verdict), program_words(view, finding.subject),
            escaped(word.empty() ? finding.verdict : word), program_words(view, finding.what),
            finding.remedy.empty() ? "" : "<p class=\"remedy\">" + program_words(view, finding.remedy) + "</p>\n");
    }
    return page(view, "doctor", body + "</ul>\n");
}

std::string backup_page(const View& view, const Preview* preview) {
    if (preview != nullptr) return page(view, "restore", title(view, "restore") + preview_of(view, *preview));
    std::string body = title(view, "backup");
    body += fmt::format("<p>{}</p>\n<p><a class=\"button\" href=\"/backup.tar.xz\">{}</a></p>\n",
                        escaped(view.say("backup.explained")), escaped(view.say("backup.take")));
    body += fmt::format(
        "<section>\n<h2>{}</h2>\n<p>{}</p>\n"
        "<form class=\"stack\" method=\"post\" action=\"/restore\" enctype=\"multipart/form-data\">{}"
        "<label for=\"file\">{}</label>\n<input id=\"file\" name=\"file\" type=\"file\" accept=\".xz\" required>\n"
        "<button>{}</button>\n</form>\n</section>\n",
        escaped(view.say("restore")), escaped(view.say("restore.explained")), token_field(view),
        escaped(view.say("restore.file", {std::to_string(kMostUpload_MB)})), escaped(view.say("restore.look")));
    return page(view, "backup", body);
}

std::string trouble_page(const View& view, const std::string& why, const std::string& words) {
    std::string told;
    if (!why.empty()) told = escaped(view.say(why));
    if (!words.empty()) told = program_words(view, words);
    return page(view, "trouble.title",
                title(view, "trouble.title") + fmt::format("<p role=\"alert\">{}</p>\n<p><a href=\"/\">{}</a></p>\n",
                                                           told, escaped(view.say("trouble.back"))));
}

}  // namespace quadrat::desk
