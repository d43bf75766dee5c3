// SPDX-License-Identifier: Apache-2.0
#include "unit/desk/desk.hpp"

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

TEST_F(ADesk, TellsNobodyAnythingWhoHasNotLoggedIn) {
    for (const char* path : {"/", "/doctor", "/report", "/backup", "/backup.tar.xz", "/faults", "/log"}) {
        const Answer answer = get(path);
        EXPECT_EQ(answer.status, 303) << path;
        EXPECT_EQ(header_of(answer, "Location"), "/login");
    }
    for (const char* path : {"/health.json", "/picture.png", "/screenshot.png", "/faults/fault-2.png"})
        EXPECT_EQ(get(path).status, 401) << path;
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
    EXPECT_EQ(get("/screenshot.png").body, "large PNG");
    EXPECT_THAT(header_of(get("/screenshot.png"), "Content-Disposition"), HasSubstr("attachment"));
    EXPECT_THAT(get("/doctor").body, HasSubstr("<p>no &lt;screen&gt;</p>\n<p class=\"remedy\">plug it in</p>"));
    EXPECT_THAT(get("/log").body, HasSubstr("it said &lt;b&gt;this&lt;/b&gt;"));
    EXPECT_THAT(get("/log").body, HasSubstr("10.0.0.7 logged in"));
    EXPECT_EQ(get("/report").body, "<html>visits</html>Back to the exhibit's page");
    EXPECT_THAT(notes, ElementsAre("10.0.0.7 logged in", "10.0.0.7 took a picture of the screen",
                                   "10.0.0.7 took a picture of the screen"));
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
    refuses = true;
    EXPECT_EQ(post("/act", {{"act", "restart"}, {"token", token()}}).status, 503);
    EXPECT_THAT(notes, Contains("10.0.0.7 asked for restart, in vain: no exhibit runs here"));
    EXPECT_EQ(ask({"GET", "/act", {}, {{"act", "wake"}}, ""}).status, 303) << "a link does nothing";
    EXPECT_EQ(acts.size(), 2U);
}

TEST_F(ADesk, DoesEachActThatAPageOffersAndNotesIt) {
    health = R"({"verdict": "good", "mode": "usual", "standing_by": false})";
    log_in();
    const auto offers = [&](const char* act) {
        return get("/").body.find(std::string("name=\"act\" value=\"") + act + "\"") != std::string::npos;
    };
    for (const char* act : {"lamps", "standby", "restart", "safe"}) EXPECT_TRUE(offers(act)) << act;
    for (const char* act : {"wake", "usual"}) EXPECT_FALSE(offers(act)) << act;
    health = R"({"verdict": "doubtful", "mode": "safe", "standing_by": true})";
    for (const char* act : {"wake", "usual"}) EXPECT_TRUE(offers(act)) << act;
    for (const char* act : {"lamps", "standby", "wake", "restart", "safe", "usual"}) {
        const Answer answer = post("/act", {{"act", act}, {"token", token()}});
        EXPECT_EQ(header_of(answer, "Location"), std::string("/?done=") + act);
        EXPECT_THAT(get("/", {{"done", act}}).body, HasSubstr("class=\"done\"")) << act;
        EXPECT_EQ(notes.back(), std::string("10.0.0.7 asked for ") + act);
    }
    EXPECT_THAT(acts,
                ElementsAre(Act::TestLamps, Act::StandBy, Act::Wake, Act::Restart, Act::SafeMode, Act::UsualMode));
    EXPECT_THAT(get("/", {{"done", "<b>"}}).body, Not(HasSubstr("class=\"done\"")));
}

TEST_F(ADesk, ShowsTheButtonsAsTheyArePressed) {
    health = R"({"verdict": "good", "buttons": {"present": true, "tests_lamps": true, "presses": 5,
        "findings": [{"button": "B", "is": "stuck"}], "each": [{"button": "A", "closed": true, "presses": 3},
        {"button": "B", "closed": false, "presses": 2}, "nonsense", {"button": "<C>", "closed": 7}]}})";
    log_in();
    const std::string page = get("/").body;
    EXPECT_THAT(page, HasSubstr("<li class=\"closed\"><b>A</b><span>pressed</span><small>Presses: 3</small></li>"));
    EXPECT_THAT(page,
                HasSubstr("<li><b>B</b><span>not pressed</span><small>Presses: 2</small><span class=\"ails\">stuck"));
    EXPECT_THAT(page, HasSubstr("<b>&lt;C&gt;</b>"));
    EXPECT_THAT(page, HasSubstr("The lamps are tested just now."));
    EXPECT_THAT(page, Not(HasSubstr("The buttons are missing.")));
    health = R"({"verdict": "bad", "buttons": {"present": false, "reason": "plug <it> in"}})";
    EXPECT_THAT(get("/").body, HasSubstr("The buttons are missing. plug &lt;it&gt; in"));
}

TEST_F(ADesk, ListsFaultsWithTheirPicturesAndNoOtherFile) {
    log_in();
    EXPECT_THAT(get("/faults").body, HasSubstr("button B is &lt;stuck&gt;"));
    EXPECT_THAT(get("/faults").body, HasSubstr("3 times, until 2026-11-26 12:00:00 UTC"));
    EXPECT_THAT(get("/faults").body, HasSubstr("src=\"/faults/fault-2.png\""));
    EXPECT_EQ(get("/faults/fault-2.png").body, "fault PNG");
    for (const char* path : {"/faults/", "/faults/fault-3.png", "/faults/../desk.passphrase", "/faults/%2e%2e/x"})
        EXPECT_EQ(get(path).status, 404) << path;
}

TEST_F(ADesk, RestoresWhatWasLookedIntoAndConfirmed) {
    log_in();
    EXPECT_EQ(post("/act", {{"act", "restore"}, {"token", token()}}).status, 400) << "nothing was brought";
    EXPECT_EQ(bring("").status, 400);
    EXPECT_EQ(bring("damaged").status, 503);
    EXPECT_EQ(post("/act", {{"act", "restore"}, {"token", token()}}).status, 400) << "what was brought is no backup";
    EXPECT_EQ(header_of(bring("whole"), "Location"), "/backup");
    const std::string page = get("/backup").body;
    for (const char* told : {"2026-11-20 10:00:00 UTC", "foyer&lt;", "<td>1234 bytes</td><td>99 bytes</td>",
                             "<td>none</td><td>7 bytes</td>"})
        EXPECT_THAT(page, HasSubstr(told));
    EXPECT_TRUE(restored.empty()) << "not before it is confirmed";
    EXPECT_EQ(post("/act", {{"act", "drop"}, {"token", token()}}).status, 303);
    EXPECT_EQ(dropped, 1);
    EXPECT_THAT(get("/backup").body, Not(HasSubstr("99 bytes")));
    bring("whole");
    const Answer done = post("/act", {{"act", "restore"}, {"who", "clone"}, {"token", token()}});
    EXPECT_EQ(header_of(done, "Location"), "/login?done=restore");
    EXPECT_THAT(restored, ElementsAre(Identity::OfTheMachine));
    EXPECT_EQ(get("/").status, 303) << "everybody is logged out: the passphrase may be another";
    EXPECT_EQ(notes.back(),
              "10.0.0.7 restored the backup of foyer<, made at 2026-11-20 10:00:00 UTC, as another machine");
}

TEST_F(ADesk, TakesAFileFromNobodyElse) {
    const auto may = [&](const std::string& method, const std::string& path, Fields headers) {
        headers["host"] = "exhibit:8080";
        if (!cookie.empty()) headers["cookie"] = cookie;
        return desk.takes_file({method, path, std::move(headers), {}, peer}, now);
    };
    EXPECT_FALSE(may("POST", "/restore", {})) << "no session";
    log_in();
    EXPECT_TRUE(may("POST", "/restore", {}));
    EXPECT_FALSE(may("POST", "/login", {}));
    EXPECT_FALSE(may("PUT", "/restore", {}));
    EXPECT_FALSE(may("POST", "/restore", {{"origin", "https://evil.example"}}));
}

TEST_F(ADesk, SpeaksTheLanguageThatIsChosenOrWished) {
    const auto language_of_page = [](const Answer& answer) {
        const std::size_t at = answer.body.find("<html lang=\"") + 12;
        return answer.body.substr(at, answer.body.find('>', at) - at);
    };
    EXPECT_EQ(language_of_page(get("/login")), "en\" dir=\"ltr\"");
    EXPECT_EQ(language_of_page(ask({"GET", "/login", {{"accept-language", "tlh, de-AT;q=0.8"}}, {}, ""})),
              "de\" dir=\"ltr\"");
    const Answer chosen = get("/login", {{"language", "ar"}});
    EXPECT_EQ(language_of_page(chosen), "ar\" dir=\"rtl\"");
    EXPECT_THAT(header_of(chosen, "Set-Cookie"), HasSubstr("quadrat-desk-language=ar;"));
    cookie = "quadrat-desk-language=fr";
    EXPECT_EQ(language_of_page(get("/login")), "fr\" dir=\"ltr\"");
    EXPECT_EQ(header_of(get("/login", {{"language", "en\r\nX: y"}}), "Set-Cookie"), "") << "no such language";
}

TEST_F(ADesk, MarksWhatTheProgramSaysAsEnglish) {
    log_in();
    cookie += "; quadrat-desk-language=ar";
    EXPECT_THAT(get("/").body, HasSubstr("<bdi lang=\"en\" dir=\"ltr\">open until 18:00</bdi>"));
    EXPECT_THAT(get("/doctor").body, HasSubstr("<bdi lang=\"en\" dir=\"ltr\">plug it in</bdi>"));
}

TEST_F(ADesk, SaysWhyAFormCannotBeUsed) {
    Request request{"POST", "/login", {}, {{"passphrase", "open sesame"}}, ""};
    request.refusal = 413;
    request.trouble = "The form is <too> long.";
    const Answer answer = ask(request);
    EXPECT_EQ(answer.status, 413);
    EXPECT_THAT(answer.body, HasSubstr("The form is &lt;too&gt; long."));
    EXPECT_TRUE(notes.empty());
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
    for (const char* path : {"/", "/login", "/doctor", "/faults", "/log", "/backup", "/report", "/nowhere", "/desk.css",
                             "/desk.js", "/backup.tar.xz", "/faults/fault-2.png"}) {
        const Answer answer = get(path);
        EXPECT_THAT(header_of(answer, "Content-Security-Policy"), HasSubstr("default-src 'none'")) << path;
        EXPECT_THAT(header_of(answer, "Content-Security-Policy"), HasSubstr("frame-ancestors 'none'")) << path;
        EXPECT_EQ(header_of(answer, "Cache-Control"), "no-store");
        EXPECT_EQ(header_of(answer, "X-Content-Type-Options"), "nosniff");
        EXPECT_EQ(header_of(answer, "Referrer-Policy"), "same-origin") << "else a browser hides where a form is from";
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
