// SPDX-License-Identifier: Apache-2.0
#include "desk/desk.hpp"

#include <fmt/format.h>

#include <array>

#include "base/error.hpp"
#include "desk/pages.hpp"
#include "desk/passphrase.hpp"

namespace quadrat::desk {
namespace {

constexpr const char* kCookie = "quadrat-desk";
// Nothing but our own files; the report brings its style within itself, and no script.
constexpr const char* kPagePolicy =
    "default-src 'none'; img-src 'self' blob:; style-src 'self'; script-src 'self'; connect-src 'self'; form-action "
    "'self'; "
    "frame-ancestors 'none'; base-uri 'none'";
constexpr const char* kReportPolicy = "default-src 'none'; style-src 'unsafe-inline'; frame-ancestors 'none'; sandbox";

struct NamedAct {
    const char* name;
    Act act;
    const char* done;  // as a page says it
};
constexpr std::array kActs{
    NamedAct{"standby", Act::StandBy, "The exhibit goes on stand-by as soon as its visitor is through."},
    NamedAct{"wake", Act::Wake, "The exhibit wakes."},
    NamedAct{"restart", Act::Restart, "The exhibit starts anew. It is back within a few seconds."}};

std::string value_in(const Fields& fields, const std::string& name) {
    const auto found = fields.find(name);
    return found == fields.end() ? std::string{} : found->second;
}

Answer redirected(const std::string& to) {
    return {303, "text/plain; charset=utf-8", "See " + to + "\n", {{"Location", to}}};
}

// A form that another site's page sends brings that site's name.
bool is_from_elsewhere(const Request& request) {
    const std::string origin = value_in(request.headers, "origin");
    if (origin.empty()) return false;
    const std::size_t slashes = origin.find("://");
    return slashes == std::string::npos || origin.substr(slashes + 3) != value_in(request.headers, "host");
}

bool is_known(const std::string& path) {
    for (const char* known : {"/", "/login", "/logout", "/act", "/doctor", "/health.json", "/picture.png", "/report",
                              "/backup.tar.xz", "/desk.css", "/desk.js"})
        if (path == known) return true;
    return false;
}

bool takes_forms(const std::string& path) { return path == "/login" || path == "/logout" || path == "/act"; }

}  // namespace

Answer Desk::answer(const Request& request, Instant now) {
    Answer answer;
    try {
        answer = route(request, now);
    } catch (const base::InputError& error) {
        answer = {503, "text/html; charset=utf-8", trouble_page(sources_, 503, error.what()), {}};
    } catch (const std::exception& error) {
        answer = {500, "text/html; charset=utf-8", trouble_page(sources_, 500, error.what()), {}};
    }
    const bool has_policy = !answer.headers.empty() && answer.headers.front().first == "Content-Security-Policy";
    if (!has_policy) answer.headers.emplace_back("Content-Security-Policy", kPagePolicy);
    answer.headers.emplace_back("Cache-Control", "no-store");
    answer.headers.emplace_back("X-Content-Type-Options", "nosniff");
    answer.headers.emplace_back("X-Frame-Options", "DENY");
    answer.headers.emplace_back("Referrer-Policy", "no-referrer");
    return answer;
}

std::string Desk::cookie(const std::string& value, long seconds) const {
    return fmt::format("{}={}; Path=/; HttpOnly; SameSite=Strict; Max-Age={}{}", kCookie, value, seconds,
                       is_encrypted_ ? "; Secure" : "");
}

Answer Desk::route(const Request& request, Instant now) {
    const auto refuse = [this](int status, const std::string& why) {
        return Answer{status, "text/html; charset=utf-8", trouble_page(sources_, status, why), {}};
    };
    if (!is_known(request.path)) return refuse(404, "There is no such page.");
    const bool is_post = request.method == "POST";
    if (!is_post && request.method != "GET" && request.method != "HEAD") {
        Answer answer = refuse(405, "A page is read, or a form is sent.");
        answer.headers.emplace_back("Allow", takes_forms(request.path) ? "GET, HEAD, POST" : "GET, HEAD");
        return answer;
    }
    if (is_post && !takes_forms(request.path)) {
        Answer answer = refuse(405, "There is no form here.");
        answer.headers.emplace_back("Allow", "GET, HEAD");
        return answer;
    }
    if (is_post && is_from_elsewhere(request)) return refuse(403, "This form was sent by a page of another site.");
    if (request.path == "/desk.css") return {200, "text/css; charset=utf-8", kStyle, {}};
    if (request.path == "/desk.js") return {200, "text/javascript; charset=utf-8", kScript, {}};
    if (request.path == "/login") return log_in(request, now);

    const std::string own = cookie_of(value_in(request.headers, "cookie"), kCookie);
    const Sessions::Session* session = sessions_.find(own, now);
    if (session == nullptr) {
        // What the script asks for is not led to a page.
        if (request.path == "/health.json" || request.path == "/picture.png") return refuse(401, "Log in first.");
        return redirected("/login");
    }
    if (!is_post) return page_of(request, *session);
    if (!are_same_secrets(value_in(request.form, "token"), session->form_token))
        return refuse(403, "This form is not one of this session: load the page again.");
    if (request.path == "/act") return carry_out(request);
    sessions_.end(own);
    sources_.note(fmt::format("{} logged out", request.peer));
    Answer answer = redirected("/login");
    answer.headers.emplace_back("Set-Cookie", cookie("", 0));
    return answer;
}

Answer Desk::log_in(const Request& request, Instant now) {
    if (request.method != "POST") return {200, "text/html; charset=utf-8", login_page(sources_, ""), {}};
    if (const auto wait = sessions_.wait_of(request.peer, now)) {
        const long seconds = static_cast<long>((wait->count() + 999) / 1000);
        return {429,
                "text/html; charset=utf-8",
                login_page(sources_, fmt::format("Too many wrong passphrases: try again in {} s.", seconds)),
                {{"Retry-After", std::to_string(seconds)}}};
    }
    if (!sources_.is_passphrase(value_in(request.form, "passphrase"))) {
        sessions_.failed(request.peer, now);
        sources_.note(fmt::format("{} gave a wrong passphrase", request.peer));
        return {403, "text/html; charset=utf-8", login_page(sources_, "That is not the passphrase."), {}};
    }
    sources_.note(fmt::format("{} logged in", request.peer));
    Answer answer = redirected("/");
    answer.headers.emplace_back("Set-Cookie", cookie(sessions_.begin(now), 12L * 3600));
    return answer;
}

Answer Desk::carry_out(const Request& request) {
    const std::string name = value_in(request.form, "act");
    for (const NamedAct& known : kActs) {
        if (name != known.name) continue;
        sources_.act(known.act);
        sources_.note(fmt::format("{} asked for {}", request.peer, known.name));
        return redirected(fmt::format("/?done={}", known.name));
    }
    return {400, "text/html; charset=utf-8", trouble_page(sources_, 400, "Nobody here knows how to do that."), {}};
}

Answer Desk::page_of(const Request& request, const Sessions::Session& session) {
    if (request.path == "/health.json") {
        auto health = sources_.health();
        if (!health) return {503, "application/json", "{\"verdict\": \"none\"}\n", {}};
        return {200, "application/json", std::move(*health), {}};
    }
    if (request.path == "/picture.png") {
        auto picture = sources_.picture();
        if (!picture) return {503, "text/plain; charset=utf-8", "There is no picture yet.\n", {}};
        return {200, "image/png", std::move(*picture), {}};
    }
    if (request.path == "/report")
        return {200, "text/html; charset=utf-8", sources_.report(), {{"Content-Security-Policy", kReportPolicy}}};
    if (request.path == "/backup.tar.xz") {
        sources_.note(fmt::format("{} took a backup", request.peer));
        return {200,
                "application/x-xz",
                sources_.backup(),
                {{"Content-Security-Policy", kPagePolicy},
                 {"Content-Disposition", "attachment; filename=\"quadrat-backup.tar.xz\""}}};
    }
    if (request.path == "/doctor")
        return {200, "text/html; charset=utf-8", doctor_page(sources_, sources_.examine()), {}};
    if (request.path != "/") return redirected("/");
    std::string done;
    for (const NamedAct& known : kActs)
        if (value_in(request.form, "done") == known.name) done = known.done;
    return {200, "text/html; charset=utf-8", exhibit_page(sources_, sources_.health(), session.form_token, done), {}};
}

}  // namespace quadrat::desk
