// SPDX-License-Identifier: Apache-2.0
// A landscape goes home: from the finale's code, as zbar reads it from the screen, to a picture drawn elsewhere.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "journeys/quadrat_program.hpp"
#include "support/effort.hpp"

namespace {

using namespace quadrat::tests;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kAddress = "https://museum.example/quadrat/";

// What zbar reads from the screen, as soon as it reads something.
std::string read_from_the_screen(Process& exhibit, const TemporaryFolder& folder) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds{kIsSanitized ? 400 : 120};
    while (exhibit.is_running() && std::chrono::steady_clock::now() < until) {
        const TemporaryFolder elsewhere;
        const Ended shot = run(program({"shot", "-o", "now.png", "--state", (folder / "state").string()}), elsewhere);
        if (shot.status != 0) continue;
        const Ended read = run({"zbarimg", "--quiet", "--raw", "now.png"}, elsewhere);
        if (read.status == 0) return read.out.substr(0, read.out.find('\n'));
    }
    ADD_FAILURE() << "no code was seen: " << contents_of(folder / "stderr.txt");
    return "";
}

std::string code_of(const std::string& scene, const TemporaryFolder& folder) {
    const Ended encoded = run(program({"code", "encode", scene}), folder);
    EXPECT_TRUE(succeeds(encoded));
    return encoded.out.substr(0, encoded.out.find('\n'));
}

TEST(TakeHome, TheCodeOnTheScreenIsTheLandscapeThatWasBredAndDrawsItElsewhere) {
    const TemporaryFolder folder;
    folder.write(
        "site.toml",
        "[picture]\nland_samples = 65\nalpha = 0.1\n[visit]\nrounds = 1\nfinale_s = 600\n[take_home]\nurl = \"" +
            kAddress + "\"\n");
    folder.write("visit.script", "at 2s press A\nafter 3s press B\nafter 3s press C\nafter 3s press D\nwait 900s\n");
    Process exhibit(program({"run", "--config", "site.toml", "--display", "headless", "--size", "1280x720", "--input",
                             "script:visit.script", "--state", "state", "--seed", "5", "--speed", "1.001", "--capture",
                             "pictures"}),
                    folder.path());
    const std::string address = read_from_the_screen(exhibit, folder);
    ASSERT_THAT(address, StartsWith(kAddress + "Q"));
    exhibit.kill(SIGTERM);
    EXPECT_TRUE(succeeds(exhibit.wait()));

    const Ended encoded = run(program({"code", "encode", "pictures/finale-01.png"}), folder);
    ASSERT_TRUE(succeeds(encoded));
    EXPECT_EQ(kAddress + encoded.out, address + "\n") << "the picture of the finale carries the same scene";
    // Drawn from the code alone, in the ways in which the finale's picture was drawn: the same, bit for bit.
    const Ended decoded = run(program({"code", "decode", address}), folder);
    ASSERT_TRUE(succeeds(decoded));
    folder.write("mine.json",
                 "{\"quadrat\":\"picture\",\"version\":1,\"land_samples\":65,\"scenes\":[" + decoded.out + "]}");
    for (const auto& [scene, picture] : {std::pair{"mine.json", "mine.png"}, {"pictures/finale-01.png", "seen.png"}})
        EXPECT_TRUE(succeeds(run(
            program({"render", scene, "-o", picture, "--size", "160x90", "--detail", "1", "--time", "0"}), folder)));
    EXPECT_EQ(contents_of(folder / "mine.png"), contents_of(folder / "seen.png"));
    EXPECT_TRUE(succeeds(run(program({"render", address, "-o", "home.png", "--size", "160x90"}), folder)));
}

TEST(TakeHome, APostcardIsReadFromPaperAndDrawsItsLandscapeAgain) {
    const TemporaryFolder folder;
    folder.write("scene.json", "{\"quadrat\":\"picture\",\"version\":1,\"land_samples\":65,\"scenes\":[" +
                                   run(program({"code", "decode", code_of("seed:7", folder)}), folder).out + "]}");
    const Ended made = run(program({"postcard", "scene.json", "-o", "card.png", "--language", "de", "--place", "Museum",
                                    "--date", "12. 10. 2026", "--address", kAddress}),
                           folder);
    ASSERT_TRUE(succeeds(made));
    EXPECT_THAT(made.out, HasSubstr("/card.png\n"));
    const Ended read = run({"zbarimg", "--quiet", "--raw", "card.png"}, folder);
    ASSERT_TRUE(succeeds(read));
    EXPECT_EQ(read.out, kAddress + code_of("seed:7", folder) + "\n");
    EXPECT_EQ(code_of("card.png", folder), code_of("seed:7", folder)) << "it carries its scene";
    EXPECT_EQ(run(program({"postcard", "seed:7", "-o", "card.jpg"}), folder).status, 2);
    EXPECT_EQ(run(program({"postcard", "nothing.json", "-o", "card.png"}), folder).status, 2);
}

TEST(TakeHome, APageHasThePostcardThatTheFinalesCodeLeadsTo) {
    const TemporaryFolder folder;
    const std::string page_address = "https://museum.example/quadrat/#";
    folder.write("site.toml",
                 "[picture]\nland_samples = 65\nalpha = 0.1\n[visit]\nrounds = 1\nfinale_s = 5\ndescribe_words = 0\n"
                 "family = false\n[take_home]\nurl = \"" +
                     page_address + "\"\n[postcard]\nplace = \"Museum\"\n");
    folder.write("visit.script", "at 2s press A\nafter 3s press B\nafter 3s press C\nafter 3s press D\nwait 900s\n");
    // On the machine's own clock: what was bred is kept by who has time for it.
    Process exhibit(program({"run", "--config", "site.toml", "--display", "headless", "--size", "640x360", "--input",
                             "script:visit.script", "--state", "state", "--seed", "5", "--speed", "1.001", "--capture",
                             "pictures"}),
                    folder.path());
    const auto has_card = [&] {
        std::error_code none;
        for (const auto& file : std::filesystem::directory_iterator(folder / "state/bred", none))
            if (file.path().string().ends_with(".card.png")) return true;
        return false;
    };
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds{kIsSanitized ? 400 : 120};
    while (exhibit.is_running() && !has_card() && std::chrono::steady_clock::now() < until)
        std::this_thread::sleep_for(std::chrono::milliseconds{100});
    ASSERT_TRUE(has_card()) << contents_of(folder / "stderr.txt");
    exhibit.kill(SIGTERM);
    EXPECT_TRUE(succeeds(exhibit.wait()));
    const auto page = [&](const std::string& language) {
        return run(program({"cards", "-o", "page", "--state", "state", "--language", language, "--place", "A & B"}),
                   folder);
    };
    const Ended made = page("fr");
    ASSERT_TRUE(succeeds(made));
    EXPECT_THAT(made.out, HasSubstr("page/index.html: 1 landscapes\n"));
    const std::string html = contents_of(folder / "page/index.html");
    const std::string code = code_of("pictures/finale-01.png", folder);
    EXPECT_THAT(html, HasSubstr("<figure id=\"" + code + "\">")) << "where its code leads";
    EXPECT_THAT(html, HasSubstr("<html lang=\"fr\" dir=\"ltr\">"));
    EXPECT_THAT(html, HasSubstr("<h1>A &amp; B</h1>"));
    EXPECT_THAT(html, testing::Not(HasSubstr("<script"))) << "any server, or none, will do";
    EXPECT_THAT(html, testing::Not(testing::ContainsRegex("(src|href)=\"[^\"]*:")));
    const std::size_t link = html.find("<a href=\"") + 9;
    const std::string card = html.substr(link, html.find('"', link) - link);
    EXPECT_EQ(run({"zbarimg", "--quiet", "--raw", "page/" + card}, folder).out, page_address + code + "\n");
    // Made anew, what has gone goes, and nothing of anybody else's.
    folder.write("page/0123456789abcdef.card.png", "of another day");
    folder.write("page/logo.png", "the museum's");
    ASSERT_TRUE(succeeds(page("ar")));
    EXPECT_THAT(contents_of(folder / "page/index.html"), HasSubstr("<html lang=\"ar\" dir=\"rtl\">"));
    EXPECT_FALSE(std::filesystem::exists(folder / "page/0123456789abcdef.card.png"));
    EXPECT_TRUE(std::filesystem::exists(folder / "page/logo.png"));
    EXPECT_EQ(run(program({"cards", "-o", "site.toml", "--state", "state"}), folder).status, 2);
}

TEST(TakeHome, ACodeThatWasMisreadIsToldInOneLine) {
    const TemporaryFolder folder;
    std::string code = code_of("seed:7", folder);
    const Ended decoded = run(program({"code", "decode", code}), folder);
    EXPECT_THAT(decoded.out, StartsWith("{\"quadrat\":\"scene\",\"version\":1,"));
    std::swap(code[40], code[41]);
    code[50] = code[50] == 'A' ? 'B' : 'A';
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"code", "decode", code}, {"render", code, "-o", "x.png"}}) {
        const Ended wrong = run(program(command), folder);
        EXPECT_EQ(wrong.status, 2);
        EXPECT_THAT(wrong.err, HasSubstr("a letter of the code is not as it was written"));
        EXPECT_EQ(lines_of(wrong.err).size(), 1U) << wrong.err;
    }
    EXPECT_EQ(run(program({"code", "decode", "Q1-ABC"}), folder).status, 2);
    EXPECT_EQ(run(program({"code", "decode", code, "-o", "x.txt"}), folder).status, 2);
    EXPECT_EQ(run(program({"code", "encode", "nothing.json"}), folder).status, 2);
}

}  // namespace
