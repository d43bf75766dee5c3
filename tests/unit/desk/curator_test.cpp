// SPDX-License-Identifier: Apache-2.0
// The curator's half of the desk: what is shown, what is taken, and by whom.
#include <set>

#include "unit/desk/desk.hpp"

namespace quadrat::desk {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST_F(ADesk, ShowsACuratorWhatHoldsAndTakesWhatIsSaid) {
    EXPECT_EQ(get("/curator").status, 303);
    EXPECT_EQ(post("/curator/hours", {{"monday", "x"}}).status, 303) << "nobody has logged in";
    EXPECT_TRUE(said.empty());
    log_in();
    const std::string page = get("/curator/hours").body;
    for (const char* shown :
         {"Week &lt;1&gt;", "Mon &lt;2&gt;", "value=\"&quot;10:00&quot;\"", "name=\"word.wet.low\" value=\"-0.5\"",
          "name=\"word.wet.high\" value=\"1\"", "value=\"on\" checked", "a\nb</textarea>", "name=\"in\" value=\"de\"",
          "name=\"preview\" value=\"monday\""})
        EXPECT_THAT(page, HasSubstr(shown));
    EXPECT_THAT(page, HasSubstr("<img src=\"/curator/landscape/0123.png\""));
    EXPECT_EQ(get("/curator/landscape/0123.png").body, "PNG of it");
    EXPECT_THAT(page, HasSubstr("<a href=\"/curator/postcard/0123.png\" download>Postcard</a>"));
    EXPECT_EQ(get("/curator/postcard/0123.png").body, "a card");
    EXPECT_EQ(get("/curator/postcard/4567.png").status, 404);
    for (const char* path : {"/curator/landscape/4567.png", "/curator/landscape/0123", "/curator/landscape/.png"})
        EXPECT_EQ(get(path).status, 404) << path;
    EXPECT_EQ(get("/curator/nowhere").status, 404);
    EXPECT_EQ(post("/curator/hours", {{"monday", "10:00-12:00"}}).status, 403) << "no token";
    EXPECT_TRUE(said.empty());
    EXPECT_EQ(header_of(post("/curator/hours", {{"monday", "10:00-12:00"}, {"token", token()}}), "Location"),
              "/curator/hours?done=saved&in=de");
    EXPECT_EQ(header_of(post("/curator/hours", {{"token", token()}}), "Location"), "/curator/hours?done=same&in=de");
    EXPECT_EQ(header_of(post("/curator/hours", {{"remove", "on"}, {"token", token()}}), "Location"),
              "/curator/hours?done=same");
    EXPECT_THAT(said, ElementsAre("10.0.0.7 says", "10.0.0.7 says", "10.0.0.7 takes out"));
    EXPECT_THAT(notes, Contains("10.0.0.7 changed hours"));
}

TEST_F(ADesk, SaysWhyNothingWasChangedAndKeepsWhatWasWritten) {
    log_in();
    const Answer refused = post("/curator/hours", {{"monday", "never"}, {"others", "<c>"}, {"token", token()}});
    EXPECT_EQ(refused.status, 422);
    EXPECT_THAT(refused.body, HasSubstr("that is &lt;no&gt; time"));
    EXPECT_THAT(refused.body, HasSubstr("value=\"never\""));
    EXPECT_THAT(refused.body, HasSubstr("&lt;c&gt;</textarea>"));
    EXPECT_THAT(refused.body, Not(HasSubstr(" checked"))) << "a tick that was taken away";
    EXPECT_TRUE(said.empty());
}

TEST_F(ADesk, TakesBackAChangeAndAsksForAPreview) {
    log_in();
    EXPECT_THAT(get("/curator").body, HasSubstr("2026-11-26 10:00 UTC"));
    EXPECT_EQ(header_of(post("/curator", {{"undo", "last"}, {"token", token()}}), "Location"),
              "/curator?done=undone&what=hours");
    EXPECT_THAT(get("/curator", {{"done", "undone"}, {"what", "hours"}}).body, HasSubstr("Taken back: Opening hours."));
    changed = false;
    EXPECT_EQ(header_of(post("/curator", {{"undo", "last"}, {"token", token()}}), "Location"), "/curator?done=same");
    EXPECT_THAT(get("/curator").body, HasSubstr("Nothing was changed here yet."));
    const Answer preview =
        post("/curator/preview", {{"part", "hours"}, {"preview", "monday"}, {"monday", "now"}, {"token", token()}});
    EXPECT_THAT(preview.body, HasSubstr("src=\"/preview.png\""));
    EXPECT_THAT(preview.body, HasSubstr("value=\"now\""));
    EXPECT_THAT(said, ElementsAre("monday=now"));
    EXPECT_EQ(get("/preview.png").status, 503) << "it was not drawn yet";
}

TEST_F(ADesk, SaysWhyAPreviewIsNotDrawnYet) {
    log_in();
    std::set<std::string> said_of_it;
    for (const auto& [why, words] :
         std::vector<std::pair<std::string, std::string>>{{"visitor", "Somebody is playing: "},
                                                          {"dark", "The screen is dark: "},
                                                          {"soon", "The exhibit draws it in"},
                                                          {"gone", "No exhibit runs here"}}) {
        preview_waits = why;
        const Answer waits = get("/preview.png");
        EXPECT_EQ(waits.status, 503);
        EXPECT_THAT(waits.body, testing::StartsWith(words));
        for (const Texts& language : languages()) said_of_it.insert(language("preview." + why));
    }
    EXPECT_EQ(said_of_it.size(), 4 * languages().size()) << "each in each language";
}

TEST_F(ADesk, TakesALongFormFromACuratorAlone) {
    Request request{"POST", "/curator/texts", {}, {}, peer};
    EXPECT_FALSE(desk.takes_long_form(request, now));
    log_in();
    request.headers["cookie"] = cookie;
    EXPECT_TRUE(desk.takes_long_form(request, now));
    for (const char* other : {"/login", "/act", "/curator"}) {
        request.path = other;
        EXPECT_FALSE(desk.takes_long_form(request, now)) << other;
    }
}

}  // namespace
}  // namespace quadrat::desk
