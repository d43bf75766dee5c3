// SPDX-License-Identifier: Apache-2.0
#include "desk/pages.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/markup.hpp"

namespace quadrat::desk {
namespace {

using base::escaped;
using Json = nlohmann::json;

std::string name_of(const Sources& sources) { return escaped(sources.exhibit.empty() ? "Quadrat" : sources.exhibit); }

std::string page(const Sources& sources, const std::string& title, const std::string& body, bool has_script = false) {
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{} · {}</title>\n"
        "<link rel=\"stylesheet\" href=\"/desk.css\">\n{}</head>\n<body>\n<main>\n{}</main>\n</body>\n</html>\n",
        escaped(title), name_of(sources), has_script ? "<script src=\"/desk.js\" defer></script>\n" : "", body);
}

std::string heading(const Sources& sources, const std::string& here) {
    std::string html = fmt::format("<header>\n<h1>{}</h1>\n<nav aria-label=\"Pages\">\n", name_of(sources));
    const std::pair<const char*, const char*> pages[]{
        {"/", "Exhibit"}, {"/doctor", "Doctor"}, {"/report", "Visitors"}, {"/backup.tar.xz", "Backup"}};
    for (const auto& [path, label] : pages)
        html += fmt::format("<a href=\"{}\"{}>{}</a>\n", path, path == here ? " aria-current=\"page\"" : "", label);
    return html + "</nav>\n</header>\n";
}

// A form of one button.
std::string button(const char* path, const std::string& token, const char* act, const char* label,
                   const char* explained) {
    return fmt::format(
        "<form method=\"post\" action=\"{}\"><input type=\"hidden\" name=\"token\" value=\"{}\">"
        "<input type=\"hidden\" name=\"act\" value=\"{}\"><button>{}</button><small>{}</small></form>\n",
        path, token, act, label, explained);
}

// What another program wrote may lack anything.
std::string text_in(const Json& json, const char* name) {
    const auto found = json.find(name);
    if (found == json.end() || found->is_null()) return "";
    return found->is_string() ? found->get<std::string>() : found->dump();
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

std::string fact(const char* id, const char* name, const std::string& value) {
    return fmt::format("<div><dt>{}</dt><dd id=\"{}\">{}</dd></div>\n", name, id, escaped(value));
}

std::string running_text(double seconds) {
    const auto minutes = static_cast<long>(seconds / 60);
    if (minutes < 60) return fmt::format("{} min", minutes);
    if (minutes < 48 * 60) return fmt::format("{} h {} min", minutes / 60, minutes % 60);
    return fmt::format("{} days", minutes / 1440);
}

const char* verdict_text(const std::string& verdict) {
    if (verdict == "good") return "All is well";
    if (verdict == "doubtful") return "Something is doubtful";
    if (verdict == "bad") return "Something is wrong";
    return "The exhibit says nothing";
}

std::string facts_of(const Json& health) {
    const Json frames = object_in(health, "frames");
    const Json buttons = object_in(health, "buttons");
    std::string html = "<dl>\n";
    html += fact("opening", "open", text_in(health, "opening"));
    html += fact("screen", "screen", text_in(health, "screen"));
    html += fact("frames", "frames a second", fmt::format("{:.0f}", number_in(frames, "per_second")));
    html += fact("late", "late frames",
                 fmt::format("{:.0f} of {:.0f}", number_in(frames, "late"), number_in(frames, "shown")));
    html += fact("detail", "detail", fmt::format("{:.0f} %", 100 * number_in(health, "alpha")));
    html += fact("temperature", "temperature",
                 health.contains("temperature_c") ? fmt::format("{:.0f} °C", number_in(health, "temperature_c")) : "–");
    html += fact("presses", "presses", fmt::format("{:.0f}", number_in(buttons, "presses")));
    html += fact("visits", "visits since the start", fmt::format("{:.0f}", number_in(health, "visits")));
    html += fact("running", "running", running_text(number_in(health, "running_s")));
    html += fact("display", "GPU and mode", text_in(health, "display"));
    return html + "</dl>\n";
}

std::string faults_of(const Json& health) {
    std::string rows;
    for (const char* list : {"faults", "earlier_faults"}) {
        const auto lines = health.find(list);
        if (lines == health.end() || !lines->is_array()) continue;
        std::string some;
        for (const Json& line : *lines)
            if (line.is_string()) some.insert(0, "<li>" + escaped(line.get<std::string>()) + "</li>\n");
        rows += some;
    }
    return rows.empty() ? "<p>No fault since the start.</p>\n" : "<ol class=\"faults\" reversed>\n" + rows + "</ol>\n";
}

}  // namespace

std::string login_page(const Sources& sources, const std::string& trouble) {
    return page(
        sources, "Log in",
        fmt::format(
            "<h1>{}</h1>\n<form class=\"login\" method=\"post\" action=\"/login\">\n"
            "{}<label for=\"passphrase\">Passphrase of the staff</label>\n"
            "<input id=\"passphrase\" name=\"passphrase\" type=\"password\" maxlength=\"256\" required "
            "autofocus autocomplete=\"current-password\"{}>\n<button>Log in</button>\n</form>\n",
            name_of(sources),
            trouble.empty() ? "" : "<p id=\"trouble\" class=\"bad\" role=\"alert\">" + escaped(trouble) + "</p>\n",
            trouble.empty() ? "" : " aria-describedby=\"trouble\""));
}

std::string exhibit_page(const Sources& sources, const std::optional<std::string>& health_text,
                         const std::string& form_token, const std::string& done) {
    const Json health = Json::parse(health_text.value_or(""), nullptr, false);
    const bool is_told = health.is_object();
    const std::string verdict = is_told ? text_in(health, "verdict") : "none";
    const bool stands_by = is_told && is_in(health, "standing_by");
    std::string body = heading(sources, "/");
    if (!done.empty()) body += "<p class=\"done\" role=\"status\">" + escaped(done) + "</p>\n";
    body += fmt::format("<p id=\"verdict\" class=\"verdict {}\" role=\"status\">{}</p>\n", escaped(verdict),
                        verdict_text(verdict));
    if (!is_told)
        body += "<p>No exhibit runs here, or it has just started. <a href=\"/doctor\">Ask the doctor</a>.</p>\n";
    if (verdict == "doubtful" || verdict == "bad")
        body += "<p><a href=\"/doctor\">The doctor</a> says what mends it.</p>\n";
    body +=
        "<figure><img id=\"picture\" src=\"/picture.png\" width=\"854\" height=\"480\" alt=\"What the screen shows "
        "just now\"><figcaption id=\"pictured\">What the screen shows. Load the page again for a new picture, where "
        "it does not come by itself.</figcaption></figure>\n";
    if (is_told) body += facts_of(health);
    body += "<section aria-label=\"Acts\" class=\"acts\">\n";
    body += stands_by
                ? button("/act", form_token, "wake", "Wake", "Visitors may come again")
                : button("/act", form_token, "standby", "Stand-by", "The screen goes dark until it is woken here");
    body += button("/act", form_token, "restart", "Restart", "A visit that is under way is taken up again");
    body += button("/logout", form_token, "", "Log out", "");
    body += "</section>\n<h2>Last faults</h2>\n";
    if (is_told) body += faults_of(health);
    body += fmt::format("<footer>quadrat {}</footer>\n", escaped(sources.version));
    return page(sources, verdict_text(verdict), body, true);
}

std::string doctor_page(const Sources& sources, const std::vector<Finding>& findings) {
    std::string body = heading(sources, "/doctor") + "<h2>What the doctor finds</h2>\n<ul class=\"findings\">\n";
    for (const Finding& finding : findings)
        body += fmt::format("<li class=\"{0}\"><b>{1}</b> <span class=\"word\">{0}</span> {2}{3}</li>\n",
                            escaped(finding.verdict), escaped(finding.subject), escaped(finding.what),
                            finding.remedy.empty() ? "" : "<br><em>" + escaped(finding.remedy) + "</em>");
    return page(sources, "Doctor", body + "</ul>\n");
}

std::string trouble_page(const Sources& sources, int status, const std::string& trouble) {
    return page(sources, std::to_string(status),
                fmt::format("<h1>{}</h1>\n<p role=\"alert\">{}</p>\n<p><a href=\"/\">To the exhibit</a></p>\n", status,
                            escaped(trouble)));
}

const char* const kStyle =
    R"(:root { color-scheme: light dark; --paper: #fff; --ink: #1c2126; --quiet: #56606a; --rule: #d9dee3;
        --mark: #24548f; --good: #1b6b3a; --doubtful: #8a5a00; --bad: #b3261e; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #14171a; --ink: #e3e7ea; --quiet: #a3adb7; --rule: #333a41; --mark: #8db7ec; --good: #7fd6a0;
          --doubtful: #f0c060; --bad: #ff9a92; }
}
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.45 system-ui, sans-serif; }
main { max-width: 56rem; margin: 0 auto; padding: 1rem; }
h1 { margin: 0; font-size: 1.4rem; }
h2 { font-size: 1.1rem; margin: 1.5rem 0 .4rem; }
header { display: flex; flex-wrap: wrap; gap: .5rem 1.5rem; align-items: baseline; border-bottom: 1px solid var(--rule);
         padding-bottom: .6rem; }
nav { display: flex; flex-wrap: wrap; gap: .25rem 1rem; }
a { color: var(--mark); padding: .4rem 0; }
a[aria-current] { color: var(--ink); font-weight: 600; text-decoration: none; }
.verdict { font-size: 1.5rem; font-weight: 600; margin: 1rem 0 .5rem; }
.verdict::before { content: "●"; margin-right: .5rem; }
.good, .done { color: var(--good); }
.doubtful { color: var(--doubtful); }
.bad, .none { color: var(--bad); }
figure { margin: 0; }
figure img { display: block; width: 100%; height: auto; background: #000; color: #ccc; }
figcaption, small, footer { color: var(--quiet); font-size: .87rem; }
dl { display: grid; grid-template-columns: repeat(auto-fit, minmax(11rem, 1fr)); gap: .6rem 1.2rem; }
dt { color: var(--quiet); font-size: .87rem; }
dd { margin: 0; font-variant-numeric: tabular-nums; overflow-wrap: anywhere; }
.acts { display: flex; flex-wrap: wrap; gap: 1rem; }
.acts form { display: flex; flex-direction: column; gap: .25rem; max-width: 15rem; }
button, input { font: inherit; color: inherit; background: transparent; border: 2px solid var(--mark); border-radius: .3rem;
                padding: .6rem 1rem; min-height: 2.75rem; }
button { cursor: pointer; color: var(--mark); font-weight: 600; }
:focus-visible { outline: 3px solid var(--mark); outline-offset: 2px; }
.login { display: flex; flex-direction: column; gap: .6rem; max-width: 22rem; margin-top: 1.5rem; }
.findings { list-style: none; padding: 0; }
.findings li { color: inherit; border-left: .3rem solid var(--quiet); padding: .3rem 0 .3rem .8rem; margin: 0 0 .6rem; }
.findings .good { border-color: var(--good); }
.findings .doubtful { border-color: var(--doubtful); }
.findings .bad { border-color: var(--bad); }
.word { color: var(--quiet); }
.faults { padding-left: 2rem; }
footer { margin-top: 2rem; }
)";

const char* const kScript = R"('use strict';
// Keeps the page as the exhibit is; without this script it is loaded again by hand.
const at = (id) => document.getElementById(id);
const words = { good: 'All is well', doubtful: 'Something is doubtful', bad: 'Something is wrong' };
const say = (id, text) => { const place = at(id); if (place && place.textContent !== text) place.textContent = text; };

async function look() {
  let health = { verdict: 'none' };
  try {
    const answer = await fetch('/health.json');
    if (answer.status === 401) { location.assign('/login'); return; }
    if (answer.ok) health = await answer.json();
  } catch (trouble) { health = { verdict: 'none' }; }
  at('verdict').className = 'verdict ' + health.verdict;
  say('verdict', words[health.verdict] || 'The exhibit says nothing');
  if (!health.frames) return;
  say('opening', health.opening);
  say('screen', health.screen);
  say('frames', health.frames.per_second.toFixed(0));
  say('late', health.frames.late + ' of ' + health.frames.shown);
  say('detail', (100 * health.alpha).toFixed(0) + ' %');
  if (health.temperature_c !== undefined) say('temperature', health.temperature_c.toFixed(0) + ' °C');
  say('presses', String(health.buttons.presses));
  say('visits', String(health.visits));
}

let shown = '';
async function picture() {
  try {
    const answer = await fetch('/picture.png');
    if (!answer.ok) return;
    const fresh = URL.createObjectURL(await answer.blob());
    at('picture').src = fresh;
    if (shown) URL.revokeObjectURL(shown);
    shown = fresh;
    say('pictured', 'What the screen shows, at ' + new Date().toLocaleTimeString());
  } catch (trouble) { say('pictured', 'No picture comes: ' + trouble.message); }
}

// Nobody looks at a page that is hidden.
setInterval(() => { if (!document.hidden) { look(); picture(); } }, 2000);
)";

}  // namespace quadrat::desk
