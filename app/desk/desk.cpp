// SPDX-License-Identifier: Apache-2.0
#include "desk/desk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/error.hpp"
#include "desk/curator_answers.hpp"
#include "desk/embedded_texts.hpp"
#include "desk/pages.hpp"
#include "desk/passphrase.hpp"

namespace quadrat::desk {
namespace {

constexpr const char* kCookie = "quadrat-desk";
constexpr const char* kLanguageCookie = "quadrat-desk-language";
constexpr const char* kHtml = "text/html; charset=utf-8";
// Nothing but our own files; the report brings its style within itself, and no script.
constexpr const char* kPagePolicy =
    "default-src 'none'; img-src 'self' blob:; style-src 'self'; script-src 'self'; connect-src 'self'; form-action "
    "'self'; "
    "frame-ancestors 'none'; base-uri 'none'";
constexpr const char* kReportPolicy =
    "default-src 'none'; style-src 'unsafe-inline'; form-action 'none'; frame-ancestors 'none'; base-uri 'none'";
constexpr std::string_view kFaultPictures = "/faults/";

struct NamedAct {
    std::string_view name;
    Act act;
};
constexpr std::array kActs{NamedAct{"lamps", Act::TestLamps}, NamedAct{"standby", Act::StandBy},
                           NamedAct{"wake", Act::Wake},       NamedAct{"restart", Act::Restart},
                           NamedAct{"safe", Act::SafeMode},   NamedAct{"usual", Act::UsualMode}};

// What there is, and what it takes.
struct Place {
    std::string_view path;
    bool takes_forms;
};
constexpr std::array kPlaces{Place{"/", false},
                             Place{"/login", true},
                             Place{"/logout", true},
                             Place{"/act", true},
                             Place{"/restore", true},
                             Place{"/faults", false},
                             Place{"/log", false},
                             Place{"/doctor", false},
                             Place{"/report", false},
                             Place{"/backup", false},
                             Place{"/backup.tar.xz", false},
                             Place{"/health.json", false},
                             Place{"/picture.png", false},
                             Place{"/screenshot.png", false},
                             Place{"/preview.png", false}};

std::string value_in(const Fields& fields, const std::string& name) {
    const auto found = fields.find(name);
    return found == fields.end() ? std::string{} : found->second;
}

Answer redirected(const std::string& to) {
    return {303, "text/plain; charset=utf-8", "See " + to + "\n", {{"Location", to}}};
}

Answer download(const std::string& type, std::string bytes, const std::string& name) {
    return {200,
            type,
            std::move(bytes),
            {{"Content-Security-Policy", kPagePolicy},
             {"Content-Disposition", fmt::format("attachment; filename=\"{}\"", name)}}};
}

// A form that another site's page sends brings that site's name.
bool is_from_elsewhere(const Request& request) {
    const std::string origin = value_in(request.headers, "origin");
    if (origin.empty()) return false;
    const std::size_t slashes = origin.find("://");
    return slashes == std::string::npos || origin.substr(slashes + 3) != value_in(request.headers, "host");
}

const Place* place_at(const std::string& path) {
    static constexpr Place kFaultPicture{"", false};
    static constexpr Place kPartOfCurator{"", true};
    if (path.starts_with(kFaultPictures)) return &kFaultPicture;
    if (is_curators(path)) return &kPartOfCurator;
    const auto* found = std::ranges::find(kPlaces, std::string_view(path), &Place::path);
    return found == kPlaces.end() ? nullptr : found;
}

// What a page loads; whoever has no session any more is not led to a page there.
bool is_part_of_page(const std::string& path) { return path.ends_with(".png") || path == "/health.json"; }

// As a link of ours asks for, else as was chosen before, else as the browser wishes.
const Texts& language_for(const Request& request) {
    for (const std::string& code : {request.method == "POST" ? "" : value_in(request.form, "language"),
                                    cookie_of(value_in(request.headers, "cookie"), kLanguageCookie)})
        if (const Texts* chosen = language_of(code)) return *chosen;
    return preferred_language(value_in(request.headers, "accept-language"));
}

Answer html(std::string page, int status = 200) { return {status, kHtml, std::move(page), {}}; }

Answer web_file(const std::string& path) {
    const bool is_script = path == "/desk.js";
    return {200,
            is_script ? "text/javascript; charset=utf-8" : "text/css; charset=utf-8",
            std::string(web_files()[is_script ? 0 : 1].text),
            {}};
}

}  // namespace

Answer Desk::answer(const Request& request, Instant now) {
    const auto trouble = [&](int status, const char* words) {
        return html(trouble_page({sources_, language_for(request), "/", "", ""}, "", words), status);
    };
    Answer answer;
    try {
        answer = request.refusal == 0 ? route(request, now) : trouble(request.refusal, request.trouble.c_str());
    } catch (const base::InputError& error) {
        answer = trouble(503, error.what());
    } catch (const std::exception& error) {
        answer = trouble(500, error.what());
    }
    const bool has_policy = !answer.headers.empty() && answer.headers.front().first == "Content-Security-Policy";
    if (!has_policy) answer.headers.emplace_back("Content-Security-Policy", kPagePolicy);
    const Texts* chosen = request.method == "GET" ? language_of(value_in(request.form, "language")) : nullptr;
    if (chosen != nullptr)
        answer.headers.emplace_back("Set-Cookie",
                                    fmt::format("{}={}; Path=/; SameSite=Strict; Max-Age=31536000{}", kLanguageCookie,
                                                chosen->code(), is_encrypted_ ? "; Secure" : ""));
    answer.headers.emplace_back("Cache-Control", "no-store");
    answer.headers.emplace_back("X-Content-Type-Options", "nosniff");
    answer.headers.emplace_back("X-Frame-Options", "DENY");
    // Not "no-referrer": of such pages browsers send forms with the origin "null".
    answer.headers.emplace_back("Referrer-Policy", "same-origin");
    return answer;
}

bool Desk::takes_file(const Request& request, Instant now) {
    return request.method == "POST" && request.path == "/restore" && !is_from_elsewhere(request) &&
           sessions_.find(cookie_of(value_in(request.headers, "cookie"), kCookie), now) != nullptr;
}

bool Desk::takes_long_form(const Request& request, Instant now) {
    return request.method == "POST" && request.path.starts_with("/curator/") && !is_from_elsewhere(request) &&
           sessions_.find(cookie_of(value_in(request.headers, "cookie"), kCookie), now) != nullptr;
}

std::string Desk::cookie(const std::string& value, long seconds) const {
    return fmt::format("{}={}; Path=/; HttpOnly; SameSite=Strict; Max-Age={}{}", kCookie, value, seconds,
                       is_encrypted_ ? "; Secure" : "");
}

Answer Desk::refuse(const Request& request, int status, const char* why) const {
    return html(trouble_page({sources_, language_for(request), "/", "", ""}, why, ""), status);
}

Answer Desk::route(const Request& request, Instant now) {
    if (request.path == "/desk.css" || request.path == "/desk.js") return web_file(request.path);
    const Place* place = place_at(request.path);
    if (place == nullptr) return refuse(request, 404, "trouble.page");
    const bool is_post = request.method == "POST";
    if (is_post ? !place->takes_forms : request.method != "GET" && request.method != "HEAD") {
        Answer answer = refuse(request, 405, is_post ? "trouble.form" : "trouble.method");
        answer.headers.emplace_back("Allow", place->takes_forms ? "GET, HEAD, POST" : "GET, HEAD");
        return answer;
    }
    if (is_post && is_from_elsewhere(request)) return refuse(request, 403, "trouble.elsewhere");
    if (request.path == "/login") return log_in(request, now);

    const std::string own = cookie_of(value_in(request.headers, "cookie"), kCookie);
    const Sessions::Session* session = sessions_.find(own, now);
    if (session == nullptr)
        return is_part_of_page(request.path) ? refuse(request, 401, "trouble.login") : redirected("/login");
    if (!is_post) return page_of(request, *session);
    if (!are_same_secrets(value_in(request.form, "token"), session->form_token))
        return refuse(request, 403, "trouble.token");
    if (request.path == "/act") return carry_out(request);
    if (request.path == "/restore") return look_into(request);
    if (is_curators(request.path)) return curate(request, view_of(request, *session));
    return log_out(request);
}

Answer Desk::log_in(const Request& request, Instant now) {
    const View view{sources_, language_for(request), "/login", "", ""};
    if (request.method != "POST") {
        const bool is_restored = value_in(request.form, "done") == "restore";
        return html(login_page({sources_, view.say, "/login", "", is_restored ? view.say("restore.done") : ""}, ""));
    }
    if (const auto wait = sessions_.wait_of(request.peer, now)) {
        const std::string seconds = std::to_string((wait->count() + 999) / 1000);
        Answer answer = html(login_page(view, view.say("login.wait", {seconds})), 429);
        answer.headers.emplace_back("Retry-After", seconds);
        return answer;
    }
    if (!sources_.is_passphrase(value_in(request.form, "passphrase"))) {
        sessions_.failed(request.peer, now);
        sources_.note(fmt::format("{} gave a wrong passphrase", request.peer));
        return html(login_page(view, view.say("login.wrong")), 403);
    }
    sources_.note(fmt::format("{} logged in", request.peer));
    Answer answer = redirected("/");
    answer.headers.emplace_back("Set-Cookie", cookie(sessions_.begin(now), 12L * 3600));
    return answer;
}

Answer Desk::log_out(const Request& request) {
    sessions_.end(cookie_of(value_in(request.headers, "cookie"), kCookie));
    sources_.note(fmt::format("{} logged out", request.peer));
    Answer answer = redirected("/login");
    answer.headers.emplace_back("Set-Cookie", cookie("", 0));
    return answer;
}

Answer Desk::carry_out(const Request& request) {
    const std::string name = value_in(request.form, "act");
    if (name == "restore")
        return restore(request,
                       value_in(request.form, "who") == "clone" ? Identity::OfTheMachine : Identity::OfTheBackup);
    if (name == "drop") {
        sources_.drop();
        preview_.reset();
        sources_.note(fmt::format("{} left a backup unused", request.peer));
        return redirected("/backup?done=drop");
    }
    const auto* known = std::ranges::find(kActs, std::string_view(name), &NamedAct::name);
    if (known == kActs.end()) return refuse(request, 400, "trouble.act");
    try {
        sources_.act(known->act);
    } catch (const std::exception& error) {
        sources_.note(fmt::format("{} asked for {}, in vain: {}", request.peer, known->name, error.what()));
        throw;
    }
    sources_.note(fmt::format("{} asked for {}", request.peer, known->name));
    return redirected(fmt::format("/?done={}", known->name));
}

Answer Desk::look_into(const Request& request) {
    if (request.brought.empty()) return refuse(request, 400, "restore.none");
    preview_.reset();
    sources_.note(fmt::format("{} brought a backup to look into", request.peer));
    preview_ = sources_.preview(request.brought);
    return redirected("/backup");
}

// Whoever has a session has it by the passphrase that was replaced.
Answer Desk::restore(const Request& request, Identity identity) {
    if (!preview_) return refuse(request, 400, "restore.none");
    const std::string what = fmt::format("the backup of {}, made at {}{}", preview_->host, preview_->made_at,
                                         identity == Identity::OfTheMachine ? ", as another machine" : "");
    try {
        sources_.restore(identity);
    } catch (const std::exception& error) {
        sources_.note(fmt::format("{} asked for a restore of {}, in vain: {}", request.peer, what, error.what()));
        throw;
    }
    sources_.note(fmt::format("{} restored {}", request.peer, what));
    preview_.reset();
    sessions_.end_all();
    return redirected("/login?done=restore");
}

// What is no page, for whoever has a session.
std::optional<Answer> Desk::file_of(const Request& request) {
    if (request.path == "/health.json") {
        auto health = sources_.health();
        if (!health) return Answer{503, "application/json", "{\"verdict\": \"none\"}\n", {}};
        return Answer{200, "application/json", std::move(*health), {}};
    }
    if (request.path == "/picture.png" || request.path.starts_with(kFaultPictures)) {
        auto picture = request.path == "/picture.png"
                           ? sources_.picture()
                           : sources_.fault_picture(request.path.substr(kFaultPictures.size()));
        if (picture) return Answer{200, "image/png", std::move(*picture), {}};
        const bool is_fault = request.path != "/picture.png";
        return refuse(request, is_fault ? 404 : 503, is_fault ? "trouble.page" : "trouble.picture");
    }
    if (request.path == "/preview.png") {
        auto picture = sources_.curator.preview();
        if (picture) return Answer{200, "image/png", std::move(*picture), {}};
        const std::string why = fmt::format("preview.{}", sources_.curator.why_preview_waits());
        return Answer{503, "text/plain; charset=utf-8", language_for(request)(why), {}};
    }
    if (request.path == "/report")
        return Answer{200,
                      kHtml,
                      sources_.report(language_for(request)("nav.back")),
                      {{"Content-Security-Policy", kReportPolicy}}};
    if (request.path == "/screenshot.png") {
        sources_.note(fmt::format("{} took a picture of the screen", request.peer));
        return download("image/png", sources_.full_picture(), "quadrat.png");
    }
    if (request.path == "/backup.tar.xz") {
        sources_.note(fmt::format("{} took a backup", request.peer));
        return download("application/x-xz", sources_.backup(), "quadrat-backup.tar.xz");
    }
    return std::nullopt;
}

View Desk::view_of(const Request& request, const Sessions::Session& session) const {
    return {sources_, language_for(request), request.path, session.form_token, ""};
}

Answer Desk::page_of(const Request& request, const Sessions::Session& session) {
    if (auto file = file_of(request)) return std::move(*file);
    View view = view_of(request, session);
    if (is_curators(request.path)) return curated(request, std::move(view));
    const std::string done = value_in(request.form, "done");
    if (std::ranges::find(kActs, std::string_view(done), &NamedAct::name) != kActs.end())
        view.done = view.say("act." + done + ".done");
    if (done == "drop") view.done = view.say("restore.dropped");
    if (request.path == "/") return html(exhibit_page(view, sources_.health()));
    if (request.path == "/faults") return html(faults_page(view, sources_.faults()));
    if (request.path == "/log") return html(log_page(view, sources_.log(), sources_.notes()));
    if (request.path == "/doctor") return html(doctor_page(view, sources_.examine()));
    if (request.path == "/backup") return html(backup_page(view, preview_ ? &*preview_ : nullptr));
    return redirected("/");  // where forms are sent to
}

}  // namespace quadrat::desk
