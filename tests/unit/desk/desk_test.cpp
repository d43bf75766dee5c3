// SPDX-License-Identifier: Apache-2.0
#include "desk/desk.hpp"

#include <gmock/gmock.h>

#include <random>

#include "base/error.hpp"
#include "base/listen_address.hpp"
#include "desk/passphrase.hpp"

namespace quadrat::desk {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::Pair;
using namespace std::chrono_literals;

std::string header_of(const Answer& answer, const std::string& name) {
    for (const auto& [key, value] : answer.headers)
        if (key == name) return value;
    return "";
}

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
        some.report = [this]() -> std::string {
            if (breaks) throw std::runtime_error("a fault of ours");
            return "<html>visits</html>";
        };
        some.backup = []() -> std::string { throw base::InputError("no room for a backup"); };
        some.act = [this](Act act) { acts.push_back(act); };
        some.note = [this](const std::string& what) { notes.push_back(what); };
        some.is_passphrase = [](const std::string& passphrase) { return passphrase == "open sesame"; };
        return some;
    }

    Answer ask(Request request) {
        if (!cookie.empty()) request.headers["cookie"] = "a=b; " + cookie;
        request.headers["host"] = "exhibit:8080";
        request.peer = peer;
        return desk.answer(request, now);
    }
    Answer get(const std::string& path) { return ask({"GET", path, {}, {}, ""}); }
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
    std::vector<Act> acts;
    std::vector<std::string> notes;
    std::string cookie, peer = "10.0.0.7";
    Instant now = 1h;
    Desk desk{sources(),
              [this](std::size_t count) {
                  std::string bytes;
                  for (std::size_t i = 0; i < count; ++i) bytes += static_cast<char>(chance() & 255U);
                  return bytes;
              },
              false};
};

TEST_F(ADesk, TellsNobodyAnythingWhoHasNotLoggedIn) {
    for (const char* path : {"/", "/doctor", "/report", "/backup.tar.xz"}) {
        const Answer answer = get(path);
        EXPECT_EQ(answer.status, 303) << path;
        EXPECT_EQ(header_of(answer, "Location"), "/login");
    }
    for (const char* path : {"/health.json", "/picture.png"}) EXPECT_EQ(get(path).status, 401) << path;
    EXPECT_EQ(post("/act", {{"act", "restart"}}).status, 303);
    EXPECT_TRUE(acts.empty());
    cookie = "quadrat-desk=0000";
    EXPECT_EQ(get("/").status, 303) << "a made-up session";
}

TEST_F(ADesk, ShowsHowTheExhibitIsToWhoeverHasThePassphrase) {
    log_in();
    const Answer page = get("/");
    EXPECT_EQ(page.status, 200);
    for (const char* told : {"Something is doubtful", "open until 18:00", "50 %", ">60<", "button A &lt;sticks&gt;",
                             "Foyer &lt;1&gt;", "2 of 100"})
        EXPECT_THAT(page.body, HasSubstr(told));
    EXPECT_EQ(get("/picture.png").body, "PNG");
    EXPECT_EQ(get("/picture.png").type, "image/png");
    EXPECT_EQ(get("/health.json").body, *health);
    EXPECT_THAT(get("/doctor").body, HasSubstr("no &lt;screen&gt;<br><em>plug it in</em>"));
    EXPECT_EQ(get("/report").body, "<html>visits</html>");
    EXPECT_THAT(notes, ElementsAre("10.0.0.7 logged in"));
}

TEST_F(ADesk, SaysThatNoExhibitRunsWhateverLiesThere) {
    log_in();
    for (const std::optional<std::string>& lies :
         {std::optional<std::string>{}, std::optional<std::string>{"{\"verd"}, std::optional<std::string>{"[1]"},
          std::optional<std::string>{R"({"frames": 3, "faults": {"a": 1}, "standing_by": "x", "alpha": "b"})"}}) {
        health = lies;
        const Answer page = get("/");
        EXPECT_EQ(page.status, 200) << lies.value_or("nothing");
        EXPECT_THAT(page.body, Not(HasSubstr("All is well")));
    }
    health.reset();
    EXPECT_EQ(get("/health.json").status, 503);
}

TEST_F(ADesk, ActsOnlyOnAFormOfItsOwn) {
    log_in();
    EXPECT_EQ(post("/act", {{"act", "standby"}}).status, 403) << "no token";
    EXPECT_EQ(post("/act", {{"act", "standby"}, {"token", std::string(64, '0')}}).status, 403);
    EXPECT_EQ(post("/act", {{"act", "standby"}, {"token", token()}}, {{"origin", "https://evil.example"}}).status, 403);
    EXPECT_EQ(post("/act", {{"act", "explode"}, {"token", token()}}).status, 400);
    EXPECT_TRUE(acts.empty());
    EXPECT_EQ(post("/act", {{"act", "standby"}, {"token", token()}}, {{"origin", "http://exhibit:8080"}}).status, 303);
    EXPECT_EQ(post("/act", {{"act", "restart"}, {"token", token()}}).status, 303);
    EXPECT_THAT(acts, ElementsAre(Act::StandBy, Act::Restart));
    EXPECT_THAT(notes, Contains("10.0.0.7 asked for standby"));
    EXPECT_EQ(ask({"GET", "/act", {}, {{"act", "wake"}}, ""}).status, 303) << "a link does nothing";
    EXPECT_EQ(acts.size(), 2U);
}

TEST_F(ADesk, EndsASession) {
    log_in();
    now += Sessions::kIdle - 1s;
    EXPECT_EQ(get("/").status, 200);
    now += Sessions::kIdle;
    EXPECT_EQ(get("/").status, 303) << "nobody asked for half an hour";
    log_in();
    for (int i = 0; i < 100 && get("/").status == 200; ++i) now += 10min;
    EXPECT_EQ(now % 24h > 0ms, true);
    EXPECT_EQ(get("/").status, 303) << "at the latest after twelve hours";
    log_in();
    EXPECT_EQ(post("/logout", {{"token", token()}}).status, 303);
    EXPECT_EQ(get("/").status, 303);
}

TEST_F(ADesk, LetsNobodyGuess) {
    for (int i = 0; i < Sessions::kTries; ++i) EXPECT_EQ(post("/login", {{"passphrase", "guess"}}).status, 403);
    const Answer refused = post("/login", {{"passphrase", "open sesame"}});
    EXPECT_EQ(refused.status, 429) << "not even the right one";
    EXPECT_EQ(header_of(refused, "Retry-After"), "300");
    peer = "10.0.0.8";
    EXPECT_EQ(post("/login", {{"passphrase", "open sesame"}}).status, 303) << "another address";
    for (int i = 0; i < 100; ++i) {
        peer = "10.1.0." + std::to_string(i);
        post("/login", {{"passphrase", "guess"}});
    }
    EXPECT_EQ(post("/login", {{"passphrase", "open sesame"}}).status, 429) << "many addresses at once";
    now += Sessions::kForgiven;
    EXPECT_EQ(post("/login", {{"passphrase", "open sesame"}}).status, 303);
}

TEST_F(ADesk, IsNoPlaceForOtherPagesAndNotKept) {
    log_in();
    for (const char* path : {"/", "/login", "/doctor", "/report", "/nowhere", "/desk.css", "/desk.js"}) {
        const Answer answer = get(path);
        EXPECT_THAT(header_of(answer, "Content-Security-Policy"), HasSubstr("default-src 'none'")) << path;
        EXPECT_THAT(header_of(answer, "Content-Security-Policy"), HasSubstr("frame-ancestors 'none'")) << path;
        EXPECT_EQ(header_of(answer, "Cache-Control"), "no-store");
        EXPECT_EQ(header_of(answer, "X-Content-Type-Options"), "nosniff");
    }
    EXPECT_THAT(get("/").body, Not(HasSubstr("style=")));
    EXPECT_THAT(get("/").body, Not(HasSubstr("onclick")));
}

TEST_F(ADesk, RefusesWhatItDoesNotKnow) {
    log_in();
    EXPECT_EQ(get("/../etc/passwd").status, 404);
    EXPECT_EQ(get("/%2e%2e/etc/passwd").status, 404);
    EXPECT_EQ(get("").status, 404);
    EXPECT_EQ(ask({"DELETE", "/", {}, {}, ""}).status, 405);
    EXPECT_EQ(post("/doctor", {}).status, 405);
    EXPECT_EQ(get("/backup.tar.xz").status, 503);
    EXPECT_THAT(get("/backup.tar.xz").body, HasSubstr("no room for a backup"));
    breaks = true;
    EXPECT_EQ(get("/report").status, 500);
    EXPECT_THAT(get("/report").body, HasSubstr("a fault of ours"));
}

TEST(Form, IsReadAsBrowsersWriteIt) {
    EXPECT_EQ(fields_of("a=1&b=%C3%A4+x&c=&d"), (Fields{{"a", "1"}, {"b", "ä x"}, {"c", ""}, {"d", ""}}));
    EXPECT_EQ(fields_of(""), Fields{});
    EXPECT_EQ(fields_of("a=1&a=2"), (Fields{{"a", "1"}}));
    for (const char* broken : {"a=%", "a=%1", "a=%zz", "%00=1", "a=%00"})
        EXPECT_EQ(fields_of(broken), std::nullopt) << broken;
}

TEST(Form, OfAnyBytesEndsInFieldsOrInNothing) {
    std::mt19937 chance(3);
    for (int i = 0; i < 20'000; ++i) {
        std::string bytes;
        for (auto n = chance() % 40; n > 0; --n) bytes += "%&=+;a0\x80\xff\n"[chance() % 10];
        const auto fields = fields_of(bytes);
        cookie_of(bytes, "a");
        if (!fields) continue;
        for (const auto& [name, value] : *fields) EXPECT_EQ((name + value).find('\0'), std::string::npos);
    }
}

TEST(Cookie, IsFoundAmongOthers) {
    EXPECT_EQ(cookie_of("a=1; quadrat-desk=xyz ;b=2", "quadrat-desk"), "xyz");
    EXPECT_EQ(cookie_of("xquadrat-desk=no", "quadrat-desk"), "");
    EXPECT_EQ(cookie_of("", "quadrat-desk"), "");
}

TEST(Passphrase, IsKnownByItsHashAlone) {
    const std::string hash = hash_of("a sentence of staff", "0123456789abcdef");
    EXPECT_THAT(hash, Not(HasSubstr("sentence")));
    EXPECT_TRUE(is_passphrase("a sentence of staff", hash));
    EXPECT_FALSE(is_passphrase("a sentence of Staff", hash));
    EXPECT_NE(hash, hash_of("a sentence of staff", "0123456789abcdeg"));
    const std::string damages[]{"", hash.substr(0, hash.size() - 2), "scrypt$15$zz$00", "scrypt$1$" + hash};
    for (const std::string& damaged : damages) EXPECT_FALSE(is_passphrase("a sentence of staff", damaged)) << damaged;
    EXPECT_THROW(hash_of("short", "0123456789abcdef"), base::InputError);
    EXPECT_THROW(hash_of(std::string(300, 'x'), "0123456789abcdef"), base::InputError);
}

TEST(ListenAddress, IsOneOfThisMachineInNumbers) {
    using base::parse_listen_address;
    EXPECT_EQ(parse_listen_address("127.0.0.1:8080"), (base::ListenAddress{"127.0.0.1", 8080, true}));
    EXPECT_EQ(parse_listen_address("[::1]:80"), (base::ListenAddress{"::1", 80, true}));
    EXPECT_EQ(parse_listen_address("0.0.0.0:8080"), (base::ListenAddress{"0.0.0.0", 8080, false}));
    EXPECT_EQ(base::to_text(parse_listen_address("[fd00::2]:8443")), "[fd00::2]:8443");
    for (const char* wrong : {"", "8080", ":8080", "localhost:8080", "127.0.0.1", "127.0.0.1:0", "127.0.0.1:70000",
                              "127.0.0.1:80x", "::1:80", "[127.0.0.1]:80", "[::1]", "1.2.3:80"})
        EXPECT_THROW(parse_listen_address(wrong), std::invalid_argument) << wrong;
}

}  // namespace
}  // namespace quadrat::desk
