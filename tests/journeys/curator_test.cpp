// SPDX-License-Identifier: Apache-2.0
// What a curator says at the desk, and a running exhibit hears.
#include "journeys/desk.hpp"

namespace {

using namespace quadrat::tests;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class CuratorsDesk : public StaffsPage {
  protected:
    std::string post(const std::string& part, const std::string& form) const {
        return ask("POST", "/curator" + part, form + "&token=" + token());
    }
    std::string curated() const { return contents_of(folder / "state/desk.toml"); }
    bool says(const char* what) const { return ask("GET", "/health.json").find(what) != std::string::npos; }
    std::string log() const { return contents_of(folder / "stderr.txt"); }
};

TEST_F(CuratorsDesk, IsHeardByARunningExhibitAndCanTakeItBack) {
    set_passphrase();
    Process exhibit(exhibit_alone(), folder.path());
    Process page(desk(), elsewhere.path());
    wait_until(page, "the desk", [&] { return ask("GET", "/login").starts_with("HTTP/1.1 200"); });
    EXPECT_THAT(ask("GET", "/curator"), StartsWith("HTTP/1.1 303")) << "nobody has logged in";
    log_in();
    wait_until(exhibit, "its health", [&] { return says(R"("mode": "usual")"); });

    EXPECT_THAT(post("/theme", "called=Autumn+%26+more&word.colourful.low=0.5&in=en&text.attract=Autumn+is+here"),
                HasSubstr("Location: /curator/themes?done=saved"));
    EXPECT_THAT(ask("GET", "/curator/themes"), HasSubstr("Autumn &amp; more"));
    EXPECT_THAT(post("/themes", "theme=Autumn+%26+more"), StartsWith("HTTP/1.1 303"));
    wait_until(exhibit, "the theme", [&] { return says("\"theme\": \"Autumn & more\""); });
    EXPECT_THAT(log(), HasSubstr("configuration: read anew"));
    EXPECT_THAT(ask("GET", "/curator"), HasSubstr(">Take back the last change</button>"));
    EXPECT_THAT(post("", "undo=last"), HasSubstr("Location: /curator?done=undone&what=themes"));
    wait_until(exhibit, "no theme", [&] { return says("\"theme\": \"\""); });

    EXPECT_THAT(post("/hours", "monday=closed&tuesday=&exceptions=2026-12-24+10%3A00-13%3A00"),
                StartsWith("HTTP/1.1 303"));
    EXPECT_THAT(curated(), HasSubstr("2026-12-24 = "));
    EXPECT_THAT(ask("GET", "/curator/hours"), HasSubstr("2026-12-24 10:00-13:00"));
    EXPECT_THAT(contents_of(folder / "state/desk.log"), HasSubstr("127.0.0.1 changed hours"));
    EXPECT_THAT(contents_of(folder / "state/desk.log"), HasSubstr("127.0.0.1 took back the last change of themes"));
    exhibit.kill(SIGTERM);
    EXPECT_TRUE(succeeds(exhibit.wait()));
    // The next start has it too, and the doctor says where it comes from.
    EXPECT_THAT(ask("GET", "/doctor"), HasSubstr("what was said at the desk"));
    page.kill(SIGTERM);
    EXPECT_TRUE(succeeds(page.wait()));
}

TEST_F(CuratorsDesk, IsToldWhatIsWrongAndChangesNothing) {
    set_passphrase();
    Process page(desk(), elsewhere.path());
    wait_until(page, "the desk", [&] { return ask("GET", "/login").starts_with("HTTP/1.1 200"); });
    log_in();
    EXPECT_THAT(post("/visit", "language=de&rounds=4"), StartsWith("HTTP/1.1 303"));
    const std::string before = curated();
    EXPECT_THAT(before, HasSubstr("rounds = 4"));
    struct Wrong {
        const char *part, *form, *says;
    };
    for (const Wrong& wrong : {
             Wrong{"/visit", "language=de&rounds=900", "visit.rounds is 900: it must lie between 1 and 50."},
             Wrong{"/visit", "language=de&rounds=many", "&quot;many&quot; is no number"},
             Wrong{"/visit", "language=tlh", "visit.language is &quot;tlh&quot;"},
             Wrong{"/hours", "monday=nine+to+five", "&quot;nine to five&quot; is no opening time"},
             Wrong{"/hours", "exceptions=tomorrow", "write a day and its times"},
             Wrong{"/hours", "exceptions=2026-12-24+closed%0D%0A2026-12-24+closed", "stands there twice"},
             Wrong{"/hours", "exceptions=2026-13-40+closed", "is no date"},
             Wrong{"/hours", "zone=Mars%2FBase", "hours.zone is &quot;Mars/Base&quot;"},
             Wrong{"/words", "word.wet.low=1&word.wet.high=-1", "words.wet is not a range"},
             Wrong{"/themes", "theme=winter", "visit.theme is &quot;winter&quot;"},
             Wrong{"/theme", "called=", "a theme needs a name"},
             Wrong{"/theme", "called=none", "is no theme"},
             Wrong{"/theme", "called=a&from=2026-10-12", "has no days that could be counted"},
             Wrong{"/theme", "called=a&from=soon&until=later", "is no date"},
             Wrong{"/texts", "in=en&text.attract=%F0%93%80%80%F0%9F%AB%A8", "no installed font has the letters"},
         }) {
        const std::string answer = post(wrong.part, wrong.form);
        EXPECT_THAT(answer, StartsWith("HTTP/1.1 422")) << wrong.form;
        EXPECT_THAT(answer, HasSubstr("Nothing was changed:")) << wrong.form;
        EXPECT_THAT(answer, HasSubstr(wrong.says)) << wrong.form;
    }
    EXPECT_THAT(post("/visit", "language=de&rounds=900"), HasSubstr("value=\"900\"")) << "what was written stays";
    EXPECT_THAT(post("/nowhere", "a=b"), StartsWith("HTTP/1.1 404"));
    EXPECT_THAT(ask("GET", "/curator/nowhere"), StartsWith("HTTP/1.1 404"));
    EXPECT_THAT(ask("POST", "/curator/visit", "rounds=5&language=de"), StartsWith("HTTP/1.1 403")) << "no token";
    EXPECT_THAT(post("/visit", "rounds=5&language=de&x=" + std::string(200'000, 'x')), StartsWith("HTTP/1.1 413"));
    EXPECT_EQ(curated(), before);
    EXPECT_THAT(contents_of(folder / "state/desk.log"), Not(HasSubstr("changed hours")));
    // A mistake that the technician makes is said, and what holds stays as it is.
    folder.write("quadrat.toml", "[visit]\nrounds = 0\n");
    EXPECT_THAT(post("/visit", "language=de&rounds=6"), HasSubstr("visit.rounds is 0"));
    EXPECT_EQ(curated(), before);
    page.kill(SIGTERM);
    EXPECT_TRUE(succeeds(page.wait()));
}

TEST_F(CuratorsDesk, ChoosesAmongWhatVisitorsBred) {
    set_passphrase();
    folder.write("quadrat.toml", contents_of(folder / "quadrat.toml") +
                                     "[visit]\nrounds = 1\nfinale_s = 2\ndescribe_words = 0\npatience_s = 600\n");
    folder.write("visit.script", "wait 6s\npress A\nwait 3s\npress A\nwait 3s\npress B\nwait 3s\npress C\nwait 600s\n");
    Process page(desk(), elsewhere.path());
    wait_until(page, "the desk", [&] { return ask("GET", "/login").starts_with("HTTP/1.1 200"); });
    log_in();
    EXPECT_THAT(ask("GET", "/curator/collection"), HasSubstr("Nobody has bred any landscape"));
    std::string picture;
    {
        Process exhibit(exhibit_alone(), folder.path());
        wait_until(exhibit, "a landscape", [&] {
            const std::string shown = ask("GET", "/curator/collection");
            const std::size_t at = shown.find("/curator/landscape/");
            if (at != std::string::npos) picture = shown.substr(at, shown.find('"', at) - at);
            return !picture.empty();
        });
        exhibit.kill(SIGTERM);
        EXPECT_TRUE(succeeds(exhibit.wait()));
    }
    EXPECT_THAT(ask("GET", picture), HasSubstr("\x89PNG"));
    const std::string id = picture.substr(19, 16);
    const std::string card = ask("GET", "/curator/postcard/" + id + ".png");
    EXPECT_THAT(card, HasSubstr("\x89PNG"));
    EXPECT_THAT(card, HasSubstr("Content-Disposition: attachment; filename=\"quadrat-" + id + ".png\""));
    EXPECT_THAT(ask("GET", "/curator/collection"), HasSubstr("/curator/postcard/" + id));
    EXPECT_THAT(post("/collection", "show." + id + "=favourite"), HasSubstr("done=saved"));
    EXPECT_THAT(curated(), HasSubstr("favourites = [\n    'Q"));
    // What the exhibit kept of late is gone with the power; what was chosen is not.
    std::filesystem::remove_all(folder / "state/bred");
    EXPECT_THAT(ask("GET", picture), HasSubstr("\x89PNG"));
    EXPECT_THAT(ask("GET", "/curator/collection"), HasSubstr("value=\"favourite\" selected"));
    EXPECT_THAT(post("/collection", "show." + id + "=sold"), HasSubstr("is no choice of a landscape"));
    EXPECT_THAT(post("/collection", "show." + id + "=hidden"), HasSubstr("done=saved"));
    EXPECT_THAT(curated(), HasSubstr("hidden = [\n    'Q"));
    {
        Process exhibit(exhibit_alone(), folder.path());
        wait_until(exhibit, "its health", [&] { return says(R"("mode": "usual")"); });
        EXPECT_THAT(ask("GET", "/doctor"), HasSubstr("what was said at the desk"));
        exhibit.kill(SIGTERM);
        EXPECT_TRUE(succeeds(exhibit.wait()));
    }
    EXPECT_THAT(post("/collection", "show." + id + "="), HasSubstr("done=saved"));
    EXPECT_EQ(curated(), "");
    EXPECT_THAT(ask("GET", picture), StartsWith("HTTP/1.1 404"));
    EXPECT_THAT(ask("GET", "/curator/landscape/..%2F..%2Fdesk.passphrase"), StartsWith("HTTP/1.1 404"));
    page.kill(SIGTERM);
    EXPECT_TRUE(succeeds(page.wait()));
}

TEST_F(CuratorsDesk, SeesATextAsTheExhibitDrawsItBeforeAnybodyElseDoes) {
    set_passphrase();
    Process exhibit(exhibit_alone(), folder.path());
    Process page(desk(), elsewhere.path());
    wait_until(page, "the desk", [&] { return ask("GET", "/login").starts_with("HTTP/1.1 200"); });
    log_in();
    wait_until(exhibit, "its health", [&] { return says(R"("mode": "usual")"); });
    std::string last;
    for (const char* key : {"attract", "ask.sky", "still-there", "finale", "describe.land", "closed", "take-home"}) {
        const std::string name = std::string("text.") + key;
        const std::string answer =
            post("/preview", "part=texts&in=fr&preview=" + name + "&" + name + "=Une+autre+question");
        EXPECT_THAT(answer, HasSubstr("/preview.png")) << key;
        EXPECT_THAT(answer, HasSubstr("value=\"Une autre question\"")) << key;
        wait_until(exhibit, key, [&] { return ask("GET", "/preview.png").find("\x89PNG") != std::string::npos; });
        const std::string picture = ask("GET", "/preview.png");
        EXPECT_NE(picture, last) << key;
        last = picture;
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "state/desk.toml")) << "nothing was saved";
    EXPECT_THAT(post("/preview", "part=texts&in=fr&preview=text.nowhere"), HasSubstr("there is no such text"));
    exhibit.kill(SIGTERM);
    EXPECT_TRUE(succeeds(exhibit.wait()));
    EXPECT_THAT(post("/preview", "part=texts&in=fr&preview=text.attract"), HasSubstr("no exhibit runs here"));
    page.kill(SIGTERM);
    EXPECT_TRUE(succeeds(page.wait()));
}

}  // namespace
