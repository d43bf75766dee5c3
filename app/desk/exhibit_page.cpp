// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/markup.hpp"
#include "desk/frame.hpp"
#include "desk/pages.hpp"

namespace quadrat::desk {
namespace {

using base::escaped;
using Json = nlohmann::json;

// What another program wrote may lack anything.
std::string text_in(const Json& json, const char* name) {
    const auto found = json.find(name);
    if (found == json.end() || found->is_null()) return "";
    return found->is_string() ? found->get<std::string>() : found->dump(-1, ' ', false, Json::error_handler_t::replace);
}

double number_in(const Json& json, const char* name) {
    const auto found = json.find(name);
    return found != json.end() && found->is_number() ? found->get<double>() : 0;
}

bool is_in(const Json& json, const char* name) {
    const auto found = json.find(name);
    return found != json.end() && found->is_boolean() && found->get<bool>();
}

// Of another type, or missing: an empty one.
Json object_in(const Json& json, const char* name) {
    const auto found = json.find(name);
    return found != json.end() && found->is_object() ? *found : Json::object();
}

Json list_in(const Json& json, const char* name) {
    const auto found = json.find(name);
    return found != json.end() && found->is_array() ? *found : Json::array();
}

std::string verdict_of(const Json& health) {
    const std::string verdict = text_in(health, "verdict");
    return verdict == "good" || verdict == "doubtful" || verdict == "bad" ? verdict : "none";
}

std::string fact(const View& view, const char* key, const std::string& html) {
    return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escaped(view.say(key)), html.empty() ? "–" : html);
}

std::string running_text(const View& view, double seconds) {
    const auto minutes = static_cast<long>(seconds / 60);
    const auto text = [](long number) { return std::to_string(number); };
    if (minutes < 60) return view.say("time.minutes", {text(minutes)});
    if (minutes < 48 * 60) return view.say("time.hours", {text(minutes / 60), text(minutes % 60)});
    return view.say("time.days", {text(minutes / 1440)});
}

// A word of the exhibit's that there is a text for; anything else as it says it.
std::string known_word(const View& view, const std::string& group, const std::string& word) {
    const std::string& text = view.say(group + word);
    return text.empty() ? program_words(view, word) : escaped(text);
}

std::string mode_text(const View& view, const Json& health) {
    if (text_in(health, "mode") != "safe") return escaped(view.say("mode.usual"));
    return escaped(view.say(is_in(health, "safe_as_wished") ? "mode.wished" : "mode.safe"));
}

// The last fault of this run, in one line.
std::string fault_text(const View& view, const Json& health) {
    const Json faults = list_in(health, "faults");
    if (faults.empty() || !faults.back().is_string()) return escaped(view.say("faults.none"));
    return program_words(view, faults.back().get<std::string>()) +
           fmt::format(" <a href=\"/faults\">{}</a>", escaped(view.say("faults.see")));
}

std::string facts_of(const View& view, const Json& health) {
    const Json frames = object_in(health, "frames");
    const auto whole = [](double number) { return fmt::format("{:.0f}", number); };
    std::string html = "<dl id=\"facts\" data-live>\n";
    html += fact(view, "fact.opening", program_words(view, text_in(health, "opening")));
    html += fact(view, "fact.screen", known_word(view, "screen.", text_in(health, "screen")));
    html += fact(view, "fact.mode", mode_text(view, health));
    html += fact(view, "fact.frames", whole(number_in(frames, "per_second")));
    html +=
        fact(view, "fact.late",
             escaped(view.say("fact.late.of", {whole(number_in(frames, "late")), whole(number_in(frames, "shown"))})));
    html += fact(view, "fact.detail", fmt::format("{:.0f} %", 100 * number_in(health, "alpha")));
    html += fact(view, "fact.temperature",
                 health.contains("temperature_c") ? fmt::format("{:.0f} °C", number_in(health, "temperature_c")) : "");
    html += fact(view, "fact.visits", whole(number_in(health, "visits")));
    html += fact(view, "fact.running", escaped(running_text(view, number_in(health, "running_s"))));
    html += fact(view, "fact.display", program_words(view, text_in(health, "display")));
    return html + fact(view, "fact.fault", fault_text(view, health)) + "</dl>\n";
}

std::string finding_of(const View& view, const Json& buttons, const std::string& name) {
    for (const Json& one : list_in(buttons, "findings"))
        if (one.is_object() && text_in(one, "button") == name)
            return fmt::format("<span class=\"ails\">{}</span>", program_words(view, text_in(one, "is")));
    return {};
}

std::string buttons_of(const View& view, const Json& health) {
    const Json buttons = object_in(health, "buttons");
    std::string html = fmt::format(
        "<section aria-labelledby=\"buttons-title\">\n<h2 id=\"buttons-title\">{}</h2>\n"
        "<p class=\"hint\">{}</p>\n<div id=\"buttons\" data-live>\n",
        escaped(view.say("buttons")), escaped(view.say("buttons.explained")));
    if (!is_in(buttons, "present"))
        html += fmt::format("<p class=\"bad\">{} {}</p>\n", escaped(view.say("buttons.missing")),
                            program_words(view, text_in(buttons, "reason")));
    html += "<ul class=\"buttons\">\n";
    for (const Json& one : list_in(buttons, "each")) {
        if (!one.is_object()) continue;
        const bool is_closed = is_in(one, "closed");
        const std::string name = text_in(one, "button");
        html += fmt::format("<li{}><b>{}</b><span>{}</span><small>{}</small>{}</li>\n",
                            is_closed ? " class=\"closed\"" : "", escaped(name),
                            escaped(view.say(is_closed ? "buttons.pressed" : "buttons.open")),
                            escaped(view.say("buttons.presses", {fmt::format("{:.0f}", number_in(one, "presses"))})),
                            finding_of(view, buttons, name));
    }
    html += "</ul>\n";
    if (is_in(buttons, "tests_lamps"))
        html += fmt::format("<p class=\"testing\">{}</p>\n", escaped(view.say("lamps.testing")));
    return html + "</div>\n" + act_button(view, "lamps") + "</section>\n";
}

std::string acts_of(const View& view, const Json& health) {
    std::string html = fmt::format(
        "<section class=\"acts\" aria-labelledby=\"acts-title\">\n<h2 id=\"acts-title\">{}</h2>\n"
        "<div class=\"row\">\n",
        escaped(view.say("acts")));
    html += act_button(view, is_in(health, "standing_by") ? "wake" : "standby");
    html += act_button(view, "restart");
    html += act_button(view, text_in(health, "mode") == "safe" ? "usual" : "safe");
    return html + "</div>\n</section>\n";
}

std::string picture_of(const View& view) {
    return fmt::format(
        "<figure>\n<img id=\"picture\" src=\"/picture.png\" width=\"854\" height=\"480\" alt=\"{}\">\n"
        "<figcaption><span id=\"pictured\" data-dark=\"{}\" data-shown=\"{}\">{}</span>\n"
        "<button type=\"button\" id=\"pause\" class=\"quiet\" aria-pressed=\"false\" hidden>{}</button>\n"
        "<a id=\"reload\" href=\"/\">{}</a>\n<a href=\"/screenshot.png\">{}</a></figcaption>\n</figure>\n",
        escaped(view.say("picture.alt")), escaped(view.say("picture.dark")), escaped(view.say("picture.caption")),
        escaped(view.say("picture.still")), escaped(view.say("picture.pause")), escaped(view.say("picture.reload")),
        escaped(view.say("picture.full")));
}

}  // namespace

std::string exhibit_page(const View& view, const std::optional<std::string>& health_text) {
    Json health = Json::parse(health_text.value_or(""), nullptr, false);
    const bool is_told = health.is_object();
    if (!is_told) health = Json::object();
    const std::string verdict = is_told ? verdict_of(health) : "none";
    std::string body = fmt::format(
        "<p id=\"lost\" class=\"lost\" role=\"alert\" hidden data-text=\"{}\"></p>\n"
        "<div id=\"verdict\" class=\"verdict {}\" role=\"status\" data-live>\n<h1>{}</h1>\n",
        escaped(view.say("lost")), verdict, escaped(view.say("verdict." + verdict)));
    if (verdict == "none") body += fmt::format("<p>{}</p>\n", escaped(view.say("verdict.none.explained")));
    if (verdict != "good") body += fmt::format("<p><a href=\"/doctor\">{}</a></p>\n", escaped(view.say("verdict.ask")));
    body += "</div>\n<div class=\"split\">\n" + picture_of(view);
    body += facts_of(view, health) + "</div>\n";
    return page(view, "verdict." + verdict, body + buttons_of(view, health) + acts_of(view, health));
}

}  // namespace quadrat::desk
