// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "desk/desk.hpp"
#include "desk/secrets.hpp"

// Any bytes as a request: "POST /act?a=b" on the first line, a header a line, an empty line, a form. Whoever knows the
// cookie and the token, 64 times "7", has a session. Whatever comes, an answer is not kept by anybody, shows nothing of
// the request as markup and splits no header; and nothing is done but by a form with the token.
namespace {

using namespace quadrat::desk;

const std::string kSecret(64, '7');

struct Line {
    std::string_view text, rest;
};
Line first_line(std::string_view text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    return {text.substr(0, end), text.substr(std::min(end + 1, text.size()))};
}

Request request_from(std::string_view text) {
    Request request;
    Line line = first_line(text);
    const std::size_t space = std::min(line.text.find(' '), line.text.size());
    request.method = line.text.substr(0, space);
    const std::string_view target = line.text.substr(std::min(space + 1, line.text.size()));
    const std::size_t mark = std::min(target.find('?'), target.size());
    request.path = target.substr(0, mark);
    request.peer = "10.0.0.7";
    const std::string_view query = target.substr(std::min(mark + 1, target.size()));
    for (line = first_line(line.rest); !line.text.empty(); line = first_line(line.rest)) {
        const std::size_t colon = std::min(line.text.find(": "), line.text.size());
        request.headers.emplace(line.text.substr(0, colon), line.text.substr(std::min(colon + 2, line.text.size())));
    }
    const auto form = fields_of(request.method == "POST" ? line.rest : query);
    if (!form) request.refusal = 400, request.trouble = "The form is not well-formed.";
    request.form = form.value_or(Fields{});
    if (request.headers.contains("brought")) request.brought = request.headers["brought"];
    return request;
}

struct Done {
    int acts = 0;
};

Curator curator_for(Done& done, std::string_view bytes) {
    Curator some;
    some.parts = [] { return std::vector<std::string>{"hours", "texts"}; };
    some.form = [bytes](const std::string& part, const Fields& query, const Texts&) -> std::optional<Form> {
        if (part != "hours" && part != "texts") return std::nullopt;
        const std::string any(bytes);
        Form form{part, any, {{any, any}}, any, {{any, any}, {"part", part}}, {}, any};
        using Kind = Entry::Kind;
        for (const Kind kind :
             {Kind::Line, Kind::Lines, Kind::Number, Kind::Tick, Kind::Choice, Kind::Day, Kind::Range})
            form.groups.push_back(
                {any, any, {{kind, any, any, any, any, any, any, {{any, any}}, 0, 1, 1, any, any, any, true}}});
        for (const auto& [name, value] : query) form.kept.emplace(name, value);
        return form;
    };
    some.save = [&done](const std::string& part, const Fields&, Curator::Deed, const std::string&) {
        ++done.acts;
        if (part == "texts") throw quadrat::base::InputError("it cannot be");
        return true;
    };
    some.changes = [bytes] { return std::vector<Change>{{"now", std::string(bytes), std::string(bytes)}}; };
    some.undo = [&done, bytes](const std::string&) {
        ++done.acts;
        return std::optional<std::string>(bytes);
    };
    some.ask_preview = [&done](const Fields&, const std::string&) { ++done.acts; };
    some.landscape = [](const std::string&) { return std::nullopt; };
    some.postcard = [](const std::string&) { return std::nullopt; };
    some.preview = [] { return std::nullopt; };
    return some;
}

Sources sources_for(Done& done, std::string_view bytes) {
    Sources some;
    some.exhibit = "Foyer";
    some.health = [bytes] { return std::optional<std::string>(bytes); };  // what another program wrote may be anything
    some.picture = [] { return std::nullopt; };
    some.full_picture = [] { return std::string("PNG"); };
    some.faults = [bytes] { return std::vector<Fault>{{std::string(bytes), "now", "then", 2, "fault-1.png"}}; };
    some.fault_picture = [](const std::string& name) {
        return name == "fault-1.png" ? std::optional<std::string>("PNG") : std::nullopt;
    };
    some.log = [bytes] { return std::vector<std::string>{without_secrets(bytes, {"secret"})}; };
    some.notes = [bytes] { return std::vector<std::string>{std::string(bytes)}; };
    some.examine = [bytes] { return std::vector<Finding>{{"a", "bad", std::string(bytes), "b"}}; };
    some.report = [](const std::string& back) { return back; };
    some.backup = []() -> std::string { throw quadrat::base::InputError("no room"); };
    some.preview = [bytes](const std::filesystem::path&) {
        return Preview{std::string(bytes), "host", "1", {{std::string(bytes), 1, {}}}};
    };
    some.restore = [&done](Identity) { ++done.acts; };
    some.drop = [&done] { ++done.acts; };
    some.act = [&done](Act) { ++done.acts; };
    some.note = [](const std::string&) {};
    some.curator = curator_for(done, bytes);
    some.is_passphrase = [](const std::string& passphrase) { return passphrase == "open sesame"; };
    return some;
}

void require(bool holds) {
    if (!holds) std::abort();
}

void check(const Request& request, const Answer& answer, const Done& done) {
    require(answer.status >= 200 && answer.status < 600);
    bool has_policy = false, is_unkept = false;
    for (const auto& [name, value] : answer.headers) {
        require((name + value).find_first_of(std::string("\r\n\0", 3)) == std::string::npos);
        has_policy = has_policy || (name == "Content-Security-Policy" && value.starts_with("default-src 'none'"));
        is_unkept = is_unkept || (name == "Cache-Control" && value == "no-store");
    }
    require(has_policy && is_unkept);
    if (answer.type.starts_with("text/html")) require(answer.body.find("<zq") == std::string::npos);
    const auto cookie = request.headers.find("cookie");
    const auto token = request.form.find("token");
    const bool may_act = request.method == "POST" && cookie != request.headers.end() &&
                         cookie_of(cookie->second, "quadrat-desk") == kSecret && token != request.form.end() &&
                         token->second == kSecret;
    require(may_act || done.acts == 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string_view text{reinterpret_cast<const char*>(bytes), size};
    Done done;
    // As it is written in hexadecimal, each byte is "77".
    Desk desk(
        sources_for(done, text), [](std::size_t count) { return std::string(count, '\x77'); }, false);
    desk.answer({"POST", "/login", {}, {{"passphrase", "open sesame"}}, "10.0.0.1"}, Instant{1});
    const Request request = request_from(text);
    for (int i = 2; i < 4; ++i) check(request, desk.answer(request, Instant{i}), done);
    desk.takes_file(request, Instant{4});
    desk.takes_long_form(request, Instant{4});
    cookie_of(text, "quadrat-desk");
    preferred_language(text);
    return 0;
}
