// SPDX-License-Identifier: Apache-2.0
// What comes in from outside and what goes out: whole files or none, every name, one way to read text, help.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "journeys/quadrat_program.hpp"

namespace {

using namespace quadrat::tests;
using testing::AllOf;
using testing::HasSubstr;

// The program where no file grows beyond 8 KiB, as on a disk that is full, or with its output somewhere else.
std::vector<std::string> in_shell(const std::string& before, std::vector<std::string> arguments,
                                  const std::string& after = "") {
    std::vector<std::string> command{"bash", "-c", before + " \"$0\" \"$@\" " + after};
    for (const std::string& word : program(std::move(arguments))) command.push_back(word);
    return command;
}
std::vector<std::string> on_full_disk(std::vector<std::string> arguments) {
    return in_shell("trap '' XFSZ; ulimit -f 8;", std::move(arguments));
}

struct Writer {
    const char* name;
    std::string file;
    std::vector<std::string> arguments;
};
void PrintTo(const Writer& writer, std::ostream* os) { *os << writer.name; }

class Writes : public testing::TestWithParam<Writer> {};

TEST_P(Writes, TheWholeFileOrLeavesTheOneOfBefore) {
    const TemporaryFolder folder;
    folder.write(GetParam().file, "of before");
    const Ended ended = run(on_full_disk(GetParam().arguments), folder);
    EXPECT_NE(ended.status, 0) << "success is told of a file that does not fit";
    EXPECT_THAT(ended.err, AllOf(HasSubstr(GetParam().file), HasSubstr("File too large")));
    EXPECT_EQ(contents_of(folder / GetParam().file), "of before");
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << "left behind: " << entry.path();
}

INSTANTIATE_TEST_SUITE_P(
    Tools, Writes,
    testing::Values(Writer{"RenderPng", "a.png", {"render", "seed:3", "-o", "a.png", "--size", "320x180"}},
                    Writer{"RenderExr", "a.exr", {"render", "seed:3", "-o", "a.exr", "--size", "320x180"}},
                    Writer{"FieldPng", "a.png", {"field", "fbm", "-o", "a.png", "--size", "257"}},
                    Writer{"FieldTiff", "a.tif", {"field", "fbm", "-o", "a.tif", "--size", "257"}},
                    Writer{"FieldExr", "a.exr", {"field", "fbm", "-o", "a.exr", "--size", "257"}},
                    Writer{"FieldRelief", "a.png", {"field", "fbm", "-o", "a.png", "--size", "65", "--relief"}},
                    Writer{"ExportObj", "a.obj", {"export", "seed:3", "-o", "a.obj", "--what", "tree"}},
                    Writer{"ExportGlb", "a.glb", {"export", "seed:3", "-o", "a.glb", "--what", "tree"}},
                    Writer{"FieldStreams", "a.exr", {"field", "streams", "-o", "a.exr", "--size", "129"}},
                    Writer{"Lsystem", "a.svg", {"lsystem", "bush", "-o", "a.svg"}},
                    Writer{"LsystemMap", "a.svg", {"lsystem", "map-leaf", "-o", "a.svg"}},
                    Writer{"Tiles", "a.obj", {"tiles", "ruin", "-o", "a.obj"}},
                    Writer{"LsystemText", "a.txt", {"lsystem", "bush", "-o", "a.txt"}},
                    Writer{
                        "SimulatePlot", "a.svg", {"simulate", "--visitors", "4", "--rounds", "60", "--plot", "a.svg"}}),
    [](const auto& writer) { return std::string(writer.param.name); });

TEST(Names, OfEveryKindAreWrittenAndRead) {
    const TemporaryFolder folder;
    for (const std::string& name : {std::string("what?really=yes.png"), std::string("100%04d#.png"),
                                    std::string("Gr\xC3\xB6\xC3\x9F"
                                                "e \xE6\xA8\xB9.png"),
                                    std::string("NOW.PNG")}) {
        ASSERT_TRUE(succeeds(run(program({"render", "seed:3", "-o", name, "--size", "64x36"}), folder))) << name;
        ASSERT_TRUE(std::filesystem::exists(folder / name)) << name;
        ASSERT_TRUE(succeeds(run(program({"render", name, "-o", "again.png"}), folder))) << name;
        EXPECT_EQ(contents_of(folder / "again.png"), contents_of(folder / name)) << name;
        ASSERT_TRUE(succeeds(run(program({"field", "fbm", "--size", "33", "--mask", name, "-o", "m.exr"}), folder)));
    }
}

TEST(Names, WhoseEndingIsUnknownAreRefusedBeforeWorkBegins) {
    const TemporaryFolder folder;
    const std::vector<std::vector<std::string>> commands{
        {"render", "seed:3", "-o", "now.jpg"},     {"field", "fbm", "-o", "now.jpg"},
        {"export", "seed:3", "-o", "now.jpg"},     {"lsystem", "bush", "-o", "now.jpg"},
        {"words", "sheet", "-o", "now.jpg"},       {"words", "export", "-o", "now.jpg"},
        {"simulate", "--plot", "now.jpg"},         {"bench", "trees", "--plot", "now.jpg"},
        {"bench", "trees", "--report", "now.jpg"}, {"shot", "--state", ".", "-o", "now.jpg"}};
    for (const auto& command : commands) {
        const Ended ended = run(program(command), folder);
        EXPECT_EQ(ended.status, 2) << command[0];
        EXPECT_THAT(ended.err, AllOf(HasSubstr("now.jpg: "), HasSubstr(" is written as ."))) << command[0];
    }
}

TEST(Fields, OfTheSameCommandAreTheSameBytesASecondLater) {
    const TemporaryFolder folder;
    for (const std::string& ending : {std::string(".png"), std::string(".tif"), std::string(".exr")}) {
        ASSERT_TRUE(succeeds(run(program({"field", "fbm", "--size", "65", "-o", "a" + ending}), folder)));
        std::this_thread::sleep_for(std::chrono::milliseconds{1100});  // a date's finest step
        ASSERT_TRUE(succeeds(run(program({"field", "fbm", "--size", "65", "-o", "b" + ending}), folder)));
        EXPECT_EQ(contents_of(folder / ("a" + ending)), contents_of(folder / ("b" + ending))) << ending;
    }
}

TEST(Fields, FollowAnElevationModelInMetresWhenItsRangeIsSaid) {
    const TemporaryFolder folder;
    OIIO::ImageBuf model(OIIO::ImageSpec(65, 65, 1, OIIO::TypeDesc::FLOAT));
    for (int y = 0; y < 65; ++y)
        for (int x = 0; x < 65; ++x) {
            const float height = x == 35 && y == 1 ? -9999.0F : 200.0F + 20.0F * static_cast<float>(x);
            model.setpixel(x, y, 0, &height);
        }
    ASSERT_TRUE(model.write((folder / "dem.tif").string()));
    const auto field = [&](std::vector<std::string> more) {
        std::vector<std::string> command{"field", "fbm", "--mask", "dem.tif", "--size", "65", "-o", "a.exr"};
        command.insert(command.end(), more.begin(), more.end());
        return run(program(command), folder);
    };
    const Ended refused = field({});
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("--mask-range 200:1480"));
    const Ended followed = field({"--mask-range", "200:1480"});
    ASSERT_TRUE(succeeds(followed));
    EXPECT_THAT(followed.err, HasSubstr("dem.tif: 1 of 4225 samples are holes"));
    const OIIO::ImageBuf heights((folder / "a.exr").string());
    EXPECT_LT(heights.getchannel(4, 32, 0, 0), heights.getchannel(60, 32, 0, 0) - 0.5F);
}

TEST(Fields, LoseBurrsAndKeepTheirSummitsAndTheirMean) {
    const TemporaryFolder folder;
    for (const std::string& method : {std::string("fbm"), std::string("ridged"), std::string("diamond-square")}) {
        const std::string bare = method + ".tif";
        const std::string evened = method + "-evened.tif";
        ASSERT_TRUE(succeeds(run(program({"field", method, "-o", bare}), folder)));
        ASSERT_TRUE(succeeds(run(program({"field", method, "--burrs", "0.02", "-o", evened}), folder)));
        const auto before = OIIO::ImageBufAlgo::computePixelStats(OIIO::ImageBuf((folder / bare).string()));
        const auto after = OIIO::ImageBufAlgo::computePixelStats(OIIO::ImageBuf((folder / evened).string()));
        EXPECT_NEAR(after.max.at(0), before.max.at(0), 0.02) << method;
        EXPECT_NEAR(after.avg.at(0), before.avg.at(0), 0.001) << method;
    }
}

TEST(Fields, TellWhereErosionBroughtTheEarth) {
    const TemporaryFolder folder;
    const Ended ended = run(program({"field", "fbm", "--size", "129", "--erode", "40", "-o", "a.exr"}), folder);
    ASSERT_TRUE(succeeds(ended));
    EXPECT_THAT(ended.err, testing::ContainsRegex("worn [1-9].*laid down again [1-9].*carried off the edge [1-9]"));
    EXPECT_THAT(ended.err, testing::ContainsRegex("; -?0\\.00[0-9][0-9] unaccounted for"));
}

TEST(Words, TellHowScenesComeBackAndHowFarPicksReach) {
    const TemporaryFolder folder;
    const Ended shown = run(program({"words", "show", "--scenes"}), folder);
    ASSERT_TRUE(succeeds(shown));
    EXPECT_THAT(shown.out, testing::ContainsRegex("alpine firs +heard within 0\\.[0-9]+; comes back within [01]\\."));
    const Ended reach = run(program({"words", "reach"}), folder);
    ASSERT_TRUE(succeeds(reach));
    EXPECT_THAT(reach.out, AllOf(HasSubstr(" parameters: 0 stand still"), HasSubstr(" kinds: 0 in less than 1 %")));
}

// Landscapes spread evenly over the words, described by somebody, and learnt.
TEST(Words, AskOfLandscapesAndLearnWhatIsSaidOfThem) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "state");
    ASSERT_TRUE(succeeds(run(
        program({"words", "ask", "--aspect", "sky", "--count", "3", "--size", "64x36", "-o", "asked.json"}), folder)));
    EXPECT_FALSE(contents_of(folder / "asked.png").empty());
    nlohmann::json asked = nlohmann::json::parse(contents_of(folder / "asked.json"));
    ASSERT_EQ(asked["scenes"].size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) asked["scenes"][i]["words"]["stormy"] = 0.4 * static_cast<double>(i) - 0.4;
    folder.write("answered.json", asked.dump());
    const Ended trained = run(program({"words", "train", "answered.json", "--anyway", "--state", "state"}), folder);
    ASSERT_TRUE(succeeds(trained));
    EXPECT_THAT(trained.out, HasSubstr("the map is another"));
}

TEST(StandardOutput, ThatCannotBeWrittenIsAnErrorOfEverySubcommand) {
    const TemporaryFolder folder;
    const std::vector<std::vector<std::string>> commands{{"--help"},
                                                         {"--version"},
                                                         {"lsystem", "abop-a"},
                                                         {"lsystem", "--list"},
                                                         {"words", "show"},
                                                         {"doctor", "--only", "clock"},
                                                         {"breed", "--stdio"},
                                                         {"simulate", "--visitors", "2", "--rounds", "1"},
                                                         {"man", "run"},
                                                         {"completion", "bash"}};
    for (const auto& command : commands) {
        const Ended full = run(in_shell("", command, "> /dev/full"), folder);
        EXPECT_NE(full.status, 0) << command[0];
        EXPECT_THAT(full.err, HasSubstr("quadrat: standard output: cannot be written: ")) << command[0];
        const Ended closed = run(in_shell("", command, ">&-"), folder);
        EXPECT_NE(closed.status, 0) << command[0];
    }
}

TEST(StandardOutput, ThatNobodyReadsEndsTheProgramQuietly) {
    const TemporaryFolder folder;
    // A pipe whose reader is gone before anything is written.
    const std::string script = "mkfifo p; exec 3<>p 4>p 3>&-; \"$0\" lsystem abop-a >&4; echo \" $?\"";
    const Ended ended = run({"bash", "-c", script, QUADRAT_BINARY}, folder);
    EXPECT_THAT(ended.out, HasSubstr(" 141")) << "SIGPIPE, as of every tool";
    EXPECT_EQ(ended.err, "");
}

TEST(LogFile, KeepsWhatTheRunBeforeWroteThere) {
    const TemporaryFolder folder;
    folder.write("a.log", "what went wrong before\n");
    folder.write("quadrat.toml", "\xEF\xBB\xBF[picture]\r\nland_samples = 65\r\n");
    folder.write("visit.script", "at 1s press A\r\n");
    ASSERT_TRUE(
        succeeds(run(program({"run", "--display", "headless", "--size", "64x36", "--config", "quadrat.toml", "--input",
                              "script:visit.script", "--rounds", "1", "--state", "s", "--log-file", "a.log"}),
                     folder)));
    EXPECT_THAT(contents_of(folder / "a.log"),
                AllOf(testing::StartsWith("what went wrong before\n"), HasSubstr(" info ")));
}

std::string in_utf16(const std::string& ascii) {
    std::string bytes = "\xFF\xFE";
    for (const char c : ascii) bytes += std::string{c, '\0'};
    return bytes;
}

TEST(Text, FromOutsideIsReadInOneWay) {
    const TemporaryFolder folder;
    const std::vector<std::pair<std::string, std::vector<std::string>>> readers{
        {"a.lsys", {"lsystem", "a.lsys"}},
        {"a.map", {"lsystem", "a.map"}},
        {"a.tiles", {"tiles", "a.tiles"}},
        {"a.json", {"render", "a.json", "-o", "out.png"}},
        {"b.json", {"export", "b.json", "-o", "out.obj"}},
        {"own.json", {"words", "own", "own.json"}},
        {"train.json", {"words", "--state", ".", "train", "train.json"}},
        {"fix.txt", {"field", "fbm", "-o", "out.png", "--size", "33", "--fix", "fix.txt"}},
        {"lines.txt", {"field", "fbm", "-o", "out.png", "--size", "33", "--lines", "lines.txt"}},
        {"a.script", {"run", "--display", "headless", "--state", "s", "--input", "script:a.script"}},
        {"shaders.json", {"bench", "trees", "--report", "r.html", "--shaders", "shaders.json"}}};
    const std::pair<std::string, std::string> contents[] = {{in_utf16("a = 1\n"), ": is UTF-16 text; save it as UTF-8"},
                                                            {std::string("a\nb\0c\n", 6), ":2: byte 2 is NUL"},
                                                            {"a\nGr\xF6"
                                                             "sse\n",
                                                             ":2: byte 3 is not UTF-8"}};
    for (const auto& [file, command] : readers)
        for (const auto& [bytes, said] : contents) {
            folder.write(file, bytes);
            const Ended ended = run(program(command), folder);
            EXPECT_EQ(ended.status, 2) << file << said;
            EXPECT_THAT(ended.err, HasSubstr(file + said));
        }
}

TEST(Grammars, OfABookDrawWhatTheBookDraws) {
    const TemporaryFolder folder;
    folder.write("hilbert.lsys",
                 "\xEF\xBB\xBFname: Hilbert's <curve> & more\r\nsteps: 4\r\nangle: 90\r\naxiom: L\r\n"
                 "L -> +RF-LFL-FR+\r\nR -> -LF+RFR+FL-\r\n");
    ASSERT_TRUE(succeeds(run(program({"lsystem", "hilbert.lsys", "-o", "a.svg"}), folder)));
    const std::string svg = contents_of(folder / "a.svg");
    EXPECT_EQ(count_of(svg, "<line "), 255U);
    EXPECT_EQ(count_of(svg, "<circle "), 0U);
    EXPECT_THAT(svg, HasSubstr("<title>Hilbert&#39;s &lt;curve&gt; &amp; more</title>"));
}

// As the thesis prints figure 19, it says nothing of what lies beyond its word.
TEST(Grammars, WhoseContextsNeverComeAreNamed) {
    const TemporaryFolder folder;
    folder.write("printed.lsys", "ignore: + - F\naxiom: F1F1F1\n0 < 0 > 0 -> 1\n0 < 1 > 0 -> 1\n");
    const Ended ended = run(program({"lsystem", "printed.lsys", "--steps", "40"}), folder);
    ASSERT_TRUE(succeeds(ended));
    EXPECT_EQ(ended.out, "F1F1F1\n");
    EXPECT_THAT(ended.err, AllOf(HasSubstr("printed.lsys:4: 0 < 1 > 0 -> 1 can never apply"), HasSubstr("outside: 0")));
    EXPECT_EQ(run(program({"lsystem", "kelly-19", "--steps", "4"}), folder).err, "");
}

TEST(Grammars, OfCellsDrawAPolygonACell) {
    const TemporaryFolder folder;
    folder.write("own.map", "map: four & more\nsteps: 2\nstart: A B A B\nA -> B[-A][+A]B\nB -> A\n");
    ASSERT_TRUE(succeeds(run(program({"lsystem", "own.map", "-o", "a.svg"}), folder)));
    const std::string svg = contents_of(folder / "a.svg");
    EXPECT_EQ(count_of(svg, "<polygon "), 4U);
    EXPECT_THAT(svg, HasSubstr("<title>four &amp; more</title>"));
    EXPECT_EQ(count_of(run(program({"lsystem", "own.map", "--steps", "5"}), folder).out, "\n"), 32U);
    folder.write("own.map", "map: m\nstart: A B A B\nA -> B[*A]B\n");
    EXPECT_THAT(run(program({"lsystem", "own.map"}), folder).err, HasSubstr("own.map:3:8: '*' stands where"));
    EXPECT_THAT(run(program({"lsystem", "map-leaf", "-o", "a.glb"}), folder).err, HasSubstr(".txt or .svg"));
    EXPECT_THAT(run(program({"lsystem", "bush", "--pull", "2"}), folder).err, HasSubstr("are of maps of cells"));
}

TEST(Tiles, AreMadeAfterAnExampleOrRefusedByPlace) {
    const TemporaryFolder folder;
    folder.write("own.tiles", "....\n.##.\n.##.\n....\n");
    const Ended made = run(program({"tiles", "own.tiles", "--size", "9x7x1"}), folder);
    EXPECT_TRUE(succeeds(made));
    EXPECT_EQ(count_of(made.out, "\n"), 7U);
    EXPECT_THAT(run(program({"tiles", "own.tiles", "--size", "9x7"}), folder).err, HasSubstr("write EASTxSOUTHxUP"));
    folder.write("own.tiles", "..\n. .\n");
    EXPECT_THAT(run(program({"tiles", "own.tiles"}), folder).err, HasSubstr("own.tiles:2:4: a row of 3 tiles"));
    EXPECT_THAT(run(program({"tiles", "temple"}), folder).err, HasSubstr("quadrat tiles --list names"));
}

TEST(CommandLine, AMistakeNamesTheHelpOfItsSubcommand) {
    const TemporaryFolder folder;
    const std::pair<std::vector<std::string>, const char*> mistakes[] = {
        {{"run", "--nonsense"}, "(see quadrat run --help)"},
        {{"field"}, "(see quadrat field --help)"},
        {{"words", "sheet", "--steps", "1"}, "(see quadrat words sheet --help)"},
        {{"words"}, "(see quadrat words --help)"},
        {{}, "(see quadrat --help)"}};
    for (const auto& [arguments, said] : mistakes) {
        const Ended ended = run(program(arguments), folder);
        EXPECT_EQ(ended.status, 2);
        EXPECT_THAT(ended.err, HasSubstr(said));
    }
}

TEST(CommandLine, RefusesALanguageThatIsNotSpokenAndAStateFolderThatIsNotThere) {
    const TemporaryFolder folder;
    const Ended klingon = run(program({"words", "--language", "tlh", "show"}), folder);
    EXPECT_EQ(klingon.status, 2);
    EXPECT_THAT(klingon.err, AllOf(HasSubstr("tlh is not spoken here; there are ar, de, el, en"), HasSubstr("--help")));
    EXPECT_TRUE(succeeds(run(program({"words", "--language", "de-AT", "show"}), folder)));
    for (const std::vector<std::string>& command :
         std::vector<std::vector<std::string>>{{"words", "--state", "/nope", "show"},
                                               {"words", "--state", "/nope", "export", "-o", "a.json"},
                                               {"words", "--state", "/nope", "forget"},
                                               {"words", "--state", "/nope", "train"},
                                               {"breed", "--stdio", "--state", "/nope"}}) {
        const Ended ended = run(program(command), folder);
        EXPECT_EQ(ended.status, 2) << command[2];
        EXPECT_THAT(ended.err, HasSubstr("/nope"));
        EXPECT_FALSE(std::filesystem::exists("/nope"));
    }
}

TEST(Completion, FillsInSubcommandsOptionsAndValues) {
    const TemporaryFolder folder;
    const std::string complete =
        ". <(\"$0\" completion bash); complete_words() { COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _quadrat; "
        "echo \"${COMPREPLY[*]}\"; }; complete_words quadrat ren; complete_words quadrat run --disp; "
        "complete_words quadrat run --display h; complete_words quadrat words sh; complete_words quadrat run --config "
        "x";
    const Ended ended = run({"bash", "-c", complete, QUADRAT_BINARY}, folder);
    EXPECT_EQ(ended.out, "render\n--display\nheadless\nshow sheet\n\n") << ended.err;
}

}  // namespace
