// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "desk/desk.hpp"

#include <gmock/gmock.h>

#include <random>

#include "base/error.hpp"

namespace quadrat::desk {

inline std::string header_of(const Answer& answer, const std::string& name) {
    for (const auto& [key, value] : answer.headers)
        if (key == name) return value;
    return "";
}

// A desk beside an exhibit that does as a test says, and whoever asks it.
class ADesk : public testing::Test {
  protected:
    Sources sources() {
        Sources some;
        some.exhibit = "Foyer <1>";
        some.version = "1.2";
        some.health = [this] { return health; };
        some.picture = [] { return std::optional<std::string>("PNG"); };
        some.examine = [] {
            return std::vector<Finding>{{"screen", "bad", "no <screen>", "plug it in"}, {"gpu", "good", "fine", ""}};
        };
        some.report = [this](const std::string& back) -> std::string {
            if (breaks) throw std::runtime_error("a fault of ours");
            return "<html>visits</html>" + back;
        };
        some.backup = []() -> std::string { throw base::InputError("no room for a backup"); };
        some.full_picture = [] { return std::string("large PNG"); };
        some.faults = [] {
            return std::vector<Fault>{
                {"button B is <stuck>", "2026-11-26 11:00:00 UTC", "2026-11-26 12:00:00 UTC", 3, "fault-2.png"}};
        };
        some.fault_picture = [](const std::string& name) {
            return name == "fault-2.png" ? std::optional<std::string>("fault PNG") : std::nullopt;
        };
        some.log = [] { return std::vector<std::string>{"it said <b>this</b>"}; };
        some.notes = [this] { return notes; };
        some.preview = [](const std::filesystem::path& brought) {
            if (brought == "damaged") throw base::InputError("is not a backup of Quadrat");
            return Preview{
                "2026-11-20 10:00:00 UTC", "foyer<", "1.1", {{"quadrat.db", 1234, 99}, {"words.json", {}, 7}}};
        };
        some.restore = [this](Identity identity) { restored.push_back(identity); };
        some.drop = [this] { ++dropped; };
        some.act = [this](Act act) {
            if (act == Act::Restart && refuses) throw base::InputError("no exhibit runs here");
            acts.push_back(act);
        };
        some.note = [this](const std::string& what) { notes.push_back(what); };
        some.is_passphrase = [](const std::string& passphrase) { return passphrase == "open sesame"; };
        some.curator = curator();
        return some;
    }

    Curator curator() {
        Curator some;
        some.parts = [] { return std::vector<std::string>{"hours", "texts"}; };
        some.form = [](const std::string& part, const Fields&, const Texts&) -> std::optional<Form> {
            if (part != "hours") return std::nullopt;
            Form form;
            form.part = part;
            form.kept = {{"in", "de"}};
            form.groups = {{"Week <1>",
                            "",
                            {{Entry::Kind::Line, "monday", "Mon <2>", "\"10:00\""},
                             {Entry::Kind::Range, "word.wet", "dry … wet", "-0.5 1"},
                             {Entry::Kind::Tick, "locked.sky", "Sky", "on"},
                             {Entry::Kind::Lines, "others", "Others", "a\nb"}}}};
            form.groups[0].entries[0].can_be_previewed = true;
            form.groups[0].entries[0].picture = "/curator/landscape/0123.png";
            form.groups[0].entries[0].download = "/curator/postcard/0123.png";
            form.groups[0].entries[0].download_label = "Postcard";
            return form;
        };
        some.save = [this](const std::string&, const Fields& form, Curator::Deed deed, const std::string& who) {
            if (form.contains("monday") && form.at("monday") == "never") throw base::InputError("that is <no> time");
            said.push_back(who + (deed == Curator::Deed::Remove ? " takes out" : " says"));
            return form.contains("monday");
        };
        some.changes = [this] {
            return changed ? std::vector<Change>{{"2026-11-26 10:00 UTC", "10.0.0.7", "hours"}} : std::vector<Change>{};
        };
        some.undo = [this](const std::string&) { return changed ? std::optional<std::string>("hours") : std::nullopt; };
        some.ask_preview = [this](const Fields& form, const std::string& entry) {
            said.push_back(entry + "=" + form.at(entry));
        };
        some.postcard = [](const std::string& id) {
            return id == "0123" ? std::optional<std::string>("a card") : std::nullopt;
        };
        some.landscape = [](const std::string& id) {
            return id == "0123" ? std::optional<std::string>("PNG of it") : std::nullopt;
        };
        some.preview = [] { return std::optional<std::string>(); };
        some.why_preview_waits = [this] { return preview_waits; };
        return some;
    }

    Answer ask(Request request) {
        if (!cookie.empty()) request.headers["cookie"] = "a=b; " + cookie;
        request.headers["host"] = "exhibit:8080";
        request.peer = peer;
        return desk.answer(request, now);
    }
    Answer get(const std::string& path, Fields query = {}) { return ask({"GET", path, {}, std::move(query), ""}); }
    Answer bring(const std::string& file) {
        Request request{"POST", "/restore", {}, {{"token", token()}}, ""};
        request.brought = file;
        return ask(std::move(request));
    }
    Answer post(const std::string& path, Fields form, Fields headers = {}) {
        return ask({"POST", path, std::move(headers), std::move(form), ""});
    }
    void log_in() {
        const Answer answer = post("/login", {{"passphrase", "open sesame"}});
        ASSERT_EQ(answer.status, 303);
        const std::string set = header_of(answer, "Set-Cookie");
        cookie = set.substr(0, set.find(';'));
    }
    std::string token() {
        const std::string page = get("/").body;
        const std::size_t at = page.find("name=\"token\" value=\"") + 20;
        return page.substr(at, 64);
    }

    std::mt19937 chance{7};
    bool breaks = false;
    std::optional<std::string> health = R"({"verdict": "doubtful", "opening": "open until 18:00", "alpha": 0.5,
        "frames": {"shown": 100, "late": 2, "per_second": 59.7}, "faults": ["button A <sticks>"]})";
    bool refuses = false;
    std::vector<Act> acts;
    std::vector<Identity> restored;
    int dropped = 0;
    std::vector<std::string> notes;
    std::vector<std::string> said;  // by the curator
    std::string preview_waits = "soon";
    bool changed = true;
    std::string cookie, peer = "10.0.0.7";
    Instant now = std::chrono::hours{1};
    Desk desk{sources(),
              [this](std::size_t count) {
                  std::string bytes;
                  for (std::size_t i = 0; i < count; ++i) bytes += static_cast<char>(chance() & 255U);
                  return bytes;
              },
              false};
};

}  // namespace quadrat::desk
