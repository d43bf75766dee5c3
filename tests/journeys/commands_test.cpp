// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "journeys/quadrat_program.hpp"

namespace {

using namespace quadrat::tests;

bool are_same_pixels(const std::filesystem::path& a, const std::filesystem::path& b) {
    const OIIO::ImageBuf one(a.string());
    const OIIO::ImageBuf other(b.string());
    return one.spec().width > 0 && OIIO::ImageBufAlgo::compare(one, other, 0, 0).maxerror == 0;
}

TEST(Render, APictureCarriesItsSceneAndIsDrawnAgainPixelForPixel) {
    const TemporaryFolder folder;
    ASSERT_TRUE(
        succeeds(run(program({"render", "seed:3", "-o", "a.png", "--size", "320x180", "--time", "9"}), folder)));
    ASSERT_TRUE(succeeds(run(program({"render", "a.png", "-o", "b.png"}), folder)));
    EXPECT_TRUE(are_same_pixels(folder / "a.png", folder / "b.png"));
    ASSERT_TRUE(succeeds(run(program({"render", "seed:4", "-o", "c.png", "--size", "320x180"}), folder)));
    EXPECT_FALSE(are_same_pixels(folder / "a.png", folder / "c.png"));
}

TEST(Render, WritesExrInLinearLight) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeds(run(program({"render", "seed:3", "-o", "a.exr", "--size", "160x90"}), folder)));
    const OIIO::ImageBuf picture((folder / "a.exr").string());
    EXPECT_EQ(picture.spec().width, 160);
    EXPECT_EQ(picture.spec().format, OIIO::TypeDesc::HALF);
}

TEST(Export, WritesTreesAndLandForOtherTools) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeds(run(program({"export", "seed:5", "-o", "tree.obj", "--what", "tree"}), folder)));
    const std::string obj = contents_of(folder / "tree.obj");
    EXPECT_GT(count_of(obj, "\nv "), 500U);
    EXPECT_GT(count_of(obj, "\nf "), 500U);
    ASSERT_TRUE(succeeds(run(program({"export", "seed:5", "-o", "land.glb", "--what", "land"}), folder)));
    const std::string glb = contents_of(folder / "land.glb");
    EXPECT_EQ(glb.substr(0, 4), "glTF");
    std::uint32_t length = 0;
    std::memcpy(&length, glb.data() + 8, sizeof length);
    EXPECT_EQ(length, glb.size());
    ASSERT_TRUE(succeeds(run(program({"export", "seed:5", "-o", "land.exr", "--what", "land"}), folder)));
    EXPECT_GT(OIIO::ImageBuf((folder / "land.exr").string()).spec().width, 256);
}

TEST(Field, AWindowIsTheWholesOwnBytesAndEveryMethodIsWritten) {
    const TemporaryFolder folder;
    const auto field = [&](std::vector<std::string> more) {
        more.insert(more.begin(), "field");
        const Ended ended = run(program(more), folder);
        EXPECT_EQ(ended.status, 0) << ended.err;
    };
    folder.write("five.txt", "0 0 -0.8\n64 0 -0.8\n0 64 -0.8\n64 64 -0.8\n32 32 1.4\n");
    folder.write("lines.txt", "ridge 4 4 1 30 10 1.2\nriver 60 10 0.2 40 50 -0.4\n");
    for (const std::string method : {"fbm", "square-square", "island"}) {
        // A name is read once: OpenImageIO keeps what a file of that name held.
        const std::string whole = "whole-" + method + ".tif";
        const std::string window = "window-" + method + ".tif";
        field({method, "--size", "65", "--fix", "five.txt", "--lines", "lines.txt", "-o", whole});
        field({method, "--size", "65", "--fix", "five.txt", "--lines", "lines.txt", "--window", "0,0,65,65", "-o",
               window});
        EXPECT_TRUE(are_same_pixels(folder / whole, folder / window)) << method;
    }
    field({"all", "--size", "65", "--fix", "five.txt", "--relief", "-o", "all.png"});
    EXPECT_GT(contents_of(folder / "all.png").size(), 100000U);
    field({"ridged", "--size", "65", "--burrs", "0.1", "--smooth", "1", "--erode", "3", "--repose", "35", "-o",
           "eroded.exr"});
    field({"ridged", "--size", "65", "-o", "sixteen.png"});
    field({"fbm", "--size", "65", "--mask", "sixteen.png", "-o", "masked.exr"});
    EXPECT_FALSE(contents_of(folder / "masked.exr").empty());
}

TEST(Field, InterruptedLeavesNothing) {
    const TemporaryFolder folder;
    Process process(program({"field", "ridged", "--size", "8193", "--octaves", "16", "-o", "large.exr"}),
                    folder.path());
    // It has begun when it says how far it is.
    while (process.is_running() && contents_of(folder / "stderr.txt").find('%') == std::string::npos)
        std::this_thread::yield();
    process.kill(SIGINT);
    const Ended ended = process.wait();
    EXPECT_TRUE(ends_with(ended, 130));
    EXPECT_NE(ended.err.find("large.exr was not written"), std::string::npos) << ended.err;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        EXPECT_EQ(entry.path().filename().string().find("large"), std::string::npos) << "left behind: " << entry.path();
}

TEST(Breed, AnotherProgramCanPlayAndSameSeedAndPicksGiveTheSameBytes) {
    const TemporaryFolder folder;
    std::string picks;
    for (int i = 0; i < 40; ++i)
        picks += nlohmann::json{{"pick", {{"trees", i % 4}, {"sky", (i / 4) % 4}}}}.dump() + "\n";
    picks += "{\"undo\":true}\nnonsense\n{\"lock\":\"land\"}\n{\"quit\":true}\n";
    const auto command = program({"breed", "--stdio", "--genome", "classic", "--seed", "7"});
    const Ended first = run(command, folder, picks);
    ASSERT_EQ(first.status, 0) << first.err;
    const auto lines = lines_of(first.out);
    ASSERT_EQ(lines.size(), 2U + 43U);  // hello, the first offer, and one line for each line but quit
    EXPECT_EQ(nlohmann::json::parse(lines[0])["type"], "hello");
    EXPECT_EQ(nlohmann::json::parse(lines[0])["parameters"].size(), 21U);
    EXPECT_EQ(nlohmann::json::parse(lines[1])["round"], 1);
    EXPECT_EQ(nlohmann::json::parse(lines[41])["round"], 41);
    EXPECT_EQ(nlohmann::json::parse(lines[42])["round"], 40);
    EXPECT_EQ(lines[42], lines[40]);
    EXPECT_EQ(nlohmann::json::parse(lines[43])["type"], "error");
    const auto late = nlohmann::json::parse(lines[41]);
    for (const double p : late["state"]["land"]) EXPECT_EQ(p, 0.5);
    EXPECT_EQ(run(command, folder, picks).out, first.out);
}

TEST(Breed, SpeaksInWordsUnlessToldOtherwise) {
    const TemporaryFolder folder;
    const std::string lines_in =
        "{\"pick\":{\"trees\":1,\"land\":2,\"sky\":3}}\n{\"describe\":{\"wet\":0.5}}\n{\"state\":true}\n"
        "{\"range\":{\"wet\":[0,0]}}\n{\"describe\":{\"damp\":0.5}}\n";
    const auto command = program({"breed", "--stdio", "--seed", "7"});
    const Ended ended = run(command, folder, lines_in);
    ASSERT_EQ(ended.status, 0) << ended.err;
    std::vector<nlohmann::json> lines;
    for (const std::string& line : lines_of(ended.out)) lines.push_back(nlohmann::json::parse(line));
    ASSERT_EQ(lines.size(), 7U);
    EXPECT_EQ(lines[0]["genome"], "words");
    EXPECT_EQ(lines[0]["breeder"], "belief");
    for (const auto& candidate : lines[1]["candidates"]) {
        EXPECT_EQ(candidate["words"].size(), lines[0]["words"].size());
        EXPECT_FALSE(candidate["sentence"].get<std::string>().empty());
    }
    EXPECT_EQ(lines[3]["type"], "scene");
    EXPECT_EQ(lines[3]["words"]["wet"], 0.5);
    EXPECT_EQ(lines[3]["parameters"].size(), lines[0]["parameters"].size());
    EXPECT_GT(lines[4]["state"]["trees"]["tall"]["deviation"], 0);
    EXPECT_EQ(lines[6]["type"], "error");
    EXPECT_EQ(run(command, folder, lines_in).out, ended.out);
}

TEST(Simulate, PrintsTablesAndFiguresWithTheirErrorsFromASeedAndDrawsThem) {
    const TemporaryFolder folder;
    const auto command =
        program({"simulate", "--all", "--seed", "1", "--visitors", "3", "--rounds", "5", "--plot", "plot.svg"});
    const Ended first = run(command, folder);
    ASSERT_EQ(first.status, 0) << first.err;
    EXPECT_EQ(count_of(first.out, "closeness after round"), 4U) << "two genomes, two worlds";
    EXPECT_EQ(count_of(first.out, "sliders, novice, 3 moves"), 4U);
    EXPECT_EQ(count_of(first.out, "of what the words could reach"), 4U);
    EXPECT_GT(count_of(first.out, "±"), 100U);
    for (const char* plot : {"plot.svg", "plot-2.svg", "plot-3.svg", "plot-4.svg"})
        EXPECT_GT(std::filesystem::file_size(folder / plot), 3000U) << plot;
    EXPECT_EQ(run(command, folder).out, first.out);
}

TEST(Words, AreShownWithTheirEndsInAnyLanguage) {
    const TemporaryFolder folder;
    const Ended english = run(program({"words", "show"}), folder);
    ASSERT_EQ(english.status, 0) << english.err;
    EXPECT_THAT(english.out, testing::HasSubstr("wet"));
    EXPECT_THAT(english.out, testing::HasSubstr("described scenes"));
    const Ended german = run(program({"words", "--language", "de", "show"}), folder);
    ASSERT_EQ(german.status, 0) << german.err;
    EXPECT_NE(german.out, english.out);
    EXPECT_EQ(lines_of(german.out).size(), lines_of(english.out).size());
}

// One visit that describes what it bred: the state folder then holds three answers.
void describe_a_landscape(const TemporaryFolder& folder, const std::string& answer) {
    folder.write("one.toml",
                 "[picture]\nland_samples = 65\n[visit]\nrounds = 1\ndescribe_every = 1\nlanguage = \"xh\"\n");
    folder.write("visit.script",
                 "at 2s press A\nafter 2s press A\nafter 2s press B\nafter 2s press C\n"
                 "after 4s press D\nafter 2s press " +
                     answer + "\nafter 2s press " + answer + "\nafter 2s press " + answer + "\n");
    const Ended ended = run(program({"run", "--config", "one.toml", "--display", "headless", "--size", "64x64",
                                     "--input", "script:visit.script", "--state", "state", "--seed", "3"}),
                            folder);
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(count_of(ended.err, "it was called"), 3U) << ended.err;
    EXPECT_EQ(count_of(ended.err, "the visit ends with its finale, after 1 rounds"), 1U) << ended.err;
}

TEST(Words, AreTrainedExportedAndForgottenFromWhatVisitorsSaid) {
    const TemporaryFolder folder;
    describe_a_landscape(folder, "D");
    const Ended exported = run(program({"words", "--state", "state", "export", "-o", "said.json"}), folder);
    ASSERT_EQ(exported.status, 0) << exported.err;
    const auto said = nlohmann::json::parse(contents_of(folder / "said.json"));
    EXPECT_EQ(said["quadrat"], "word map");
    EXPECT_EQ(said["visitors"].size(), 3U) << "an aspect each";

    const Ended trained = run(program({"words", "--state", "state", "train", "--anyway"}), folder);
    ASSERT_EQ(trained.status, 0) << trained.err;
    EXPECT_THAT(trained.out, testing::HasSubstr("the map is another"));
    EXPECT_TRUE(std::filesystem::exists(folder / "state" / "words.previous.json"));
    const Ended again = run(program({"words", "train", "--state", "state", "--anyway"}), folder);
    EXPECT_THAT(again.out, testing::HasSubstr("the map stays"));
    const auto shown = [&](std::vector<std::string> options) {
        options.insert(options.begin(), "words");
        options.push_back("show");
        return run(program(options), folder).out;
    };
    EXPECT_NE(shown({"--state", "state"}), shown({}));

    const Ended unsure = run(program({"words", "--state", "state", "forget"}), folder, "no\n");
    EXPECT_EQ(unsure.status, 2) << "nobody said so";
    EXPECT_THAT(unsure.err, testing::HasSubstr("3 answers of visitors"));
    EXPECT_THAT(unsure.err, testing::HasSubstr("--yes"));
    EXPECT_NE(shown({"--state", "state"}), shown({})) << "nothing was forgotten";
    const Ended forgotten = run(program({"words", "--state", "state", "forget", "--yes"}), folder);
    ASSERT_EQ(forgotten.status, 0) << forgotten.err;
    EXPECT_THAT(forgotten.out, testing::HasSubstr("3 answers are forgotten"));
    EXPECT_FALSE(std::filesystem::exists(folder / "state" / "words.previous.json"));
    EXPECT_EQ(shown({"--state", "state"}), shown({}));
    std::string copy;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "state"))
        if (entry.path().filename().string().starts_with("words.forgotten-")) copy = entry.path().string();
    ASSERT_FALSE(copy.empty()) << forgotten.out;
    EXPECT_EQ(nlohmann::json::parse(contents_of(copy))["visitors"], said["visitors"])
        << "all of it, under a dated name";
}

TEST(Words, LearnFromACuratorsFileAndSayWhatIsOddInIt) {
    const TemporaryFolder folder;
    folder.write("odd.json", R"({"quadrat":"described","version":1,"aspect":"land","scenes":[
        {"name":"our bay","words":{"wet":0.9},"parameters":{"land.sea_level":0.5,"island.share":1,"cliff.share":1}},
        {"name":"our dunes","words":{"wet":0.9},"parameters":{"dune.share":0.8,"mesa.share":0.7,"canyon.share":0.6}}]})");
    const Ended trained = run(program({"words", "--state", ".", "train", "odd.json", "--anyway"}), folder);
    ASSERT_EQ(trained.status, 0) << trained.err;
    EXPECT_THAT(trained.err, testing::HasSubstr("\"our bay\" and \"our dunes\""));
    EXPECT_THAT(trained.out, testing::HasSubstr("the map is another"));
    EXPECT_TRUE(std::filesystem::exists(folder / "words.json"));
}

// Lands that somebody calls Irish: ten, by some of their words.
std::string irish_lands() {
    nlohmann::json scenes = nlohmann::json::array();
    const auto add = [&](double value, double wet, double green, double rugged) {
        scenes.push_back({{"value", value}, {"words", {{"wet", wet}, {"green", green}, {"rugged", rugged}}}});
    };
    add(0.9, 0.7, 0.8, -0.4);
    add(0.7, 0.6, 0.5, -0.5);
    add(0.5, 0.2, 0.9, 0.1);
    add(0.3, 0.8, -0.1, -0.1);
    add(0.1, 0.1, 0.2, 0.0);
    add(-0.1, -0.3, 0.4, 0.3);
    add(-0.3, 0.4, -0.8, 0.4);
    add(-0.5, -0.7, -0.2, -0.1);
    add(-0.7, -0.6, -0.7, 0.5);
    add(-0.9, -0.9, -0.9, 0.6);
    return nlohmann::json{
        {"quadrat", "own word"}, {"version", 1}, {"name", "Irish"}, {"aspect", "land"}, {"scenes", scenes}}
        .dump();
}

TEST(Words, OfOnesOwnAreToldByTenScenesAndThenAskedFor) {
    const TemporaryFolder folder;
    folder.write("irish.json", irish_lands());
    const Ended told = run(program({"words", "own", "irish.json", "--value", "0.8", "-o", "scene.json"}), folder);
    ASSERT_EQ(told.status, 0) << told.err;
    EXPECT_THAT(told.out, testing::HasSubstr("+0.80 is "));
    EXPECT_THAT(told.out, testing::HasSubstr("green"));
    const auto scene = nlohmann::json::parse(contents_of(folder / "scene.json"));
    const Ended spoken = run(program({"breed", "--stdio", "--own-word", "irish.json"}), folder,
                             "{\"describe\":{\"Irish\":0.8}}\n{\"describe\":{\"Irish\":-0.8,\"misty\":1}}\n"
                             "{\"describe\":{\"Irish\":3}}\n{\"quit\":true}\n");
    ASSERT_EQ(spoken.status, 0) << spoken.err;
    const auto lines = lines_of(spoken.out);
    ASSERT_EQ(lines.size(), 5U);
    const auto irish = nlohmann::json::parse(lines[2]);
    const auto other = nlohmann::json::parse(lines[3]);
    EXPECT_EQ(irish["parameters"], scene["parameters"]);
    EXPECT_GT(irish["words"]["green"], other["words"]["green"]);
    EXPECT_GT(irish["words"]["wet"], other["words"]["wet"]);
    EXPECT_EQ(other["words"]["misty"], 1);
    EXPECT_EQ(nlohmann::json::parse(lines[4])["message"], "describe.Irish is 3; a word is a number from -1 to 1");
}

TEST(Words, AreDrawnARowEach) {
    const TemporaryFolder folder;
    const Ended sheet = run(program({"words", "sheet", "-o", "words.png", "--size", "32x18", "--steps", "2"}), folder);
    ASSERT_EQ(sheet.status, 0) << sheet.err;
    EXPECT_GT(std::filesystem::file_size(folder / "words.png"), 5000U);
    EXPECT_EQ(run(program({"words", "sheet", "-o", "no/such/folder/words.png"}), folder).status, 2);
}

TEST(Bench, PrintsItsResultsAsJson) {
    const TemporaryFolder folder;
    const Ended ended = run(program({"bench", "frame", "--json", "--size", "320x180", "--frames", "3"}), folder);
    ASSERT_EQ(ended.status, 0) << ended.err;
    const auto json = nlohmann::json::parse(ended.out);
    std::map<std::string, double> values;
    for (const auto& result : json["results"]) values[result["name"]] = result["value"];
    for (const char* name : {"frame.median_ms", "frame.p99_ms", "frame.cpu_ms", "frame.triangles",
                             "start.first_frame_ms", "memory.peak_mb"})
        EXPECT_GT(values[name], 0) << name;
    EXPECT_GE(values["frame.trees_least"], 200) << "what it is compared with draws as many";
}

TEST(Bench, OfARaspberryPiTellsWhatItsShadersTakeAndWhatIsLeftOut) {
    const TemporaryFolder folder;
    const Ended ended = run(
        program({"bench", "detail", "--profile", "pi4", "--json", "--size", "160x90", "--triangles", "20000"}), folder);
    ASSERT_EQ(ended.status, 0) << ended.err;
    std::map<std::string, double> values;
    const auto json = nlohmann::json::parse(ended.out);
    for (const auto& result : json["results"]) values[result["name"]] = result["value"];
    EXPECT_EQ(values["detail.pi4_instructions.leaves.frag"], 19);
    EXPECT_EQ(values["detail.pi4_instructions.sky.frag"], 48);
    for (const char* name : {"detail.pi4_assumed_signs_ms", "detail.pi4_assumed_spread_ms"})
        EXPECT_TRUE(values.contains(name)) << name;
}

// Whether every element that begins also ends, within the one that it began in.
bool is_well_formed(const std::string& xml) {
    std::vector<std::string> open;
    for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
        const std::size_t end = xml.find('>', at);
        if (end == std::string::npos) return false;
        const std::string tag = xml.substr(at + 1, end - at - 1);
        if (std::ranges::count(tag, '"') % 2 != 0 || tag.find('<') != std::string::npos) return false;
        if (tag.ends_with('/')) continue;
        if (!tag.starts_with('/')) {
            open.push_back(tag.substr(0, tag.find(' ')));
            continue;
        }
        if (open.empty() || open.back() != tag.substr(1)) return false;
        open.pop_back();
    }
    return open.empty();
}

TEST(Bench, OfAVisitPlotsItsFrames) {
    const TemporaryFolder folder;
    const Ended ended = run(program({"bench", "visit", "--json", "--minutes", "0.1", "--size", "160x90", "--busy",
                                     "--hz", "60", "--then-hz", "30", "--plot", "visit.svg", "--report", "visit.html"}),
                            folder);
    ASSERT_EQ(ended.status, 0) << ended.err;
    std::map<std::string, double> values;
    const auto json = nlohmann::json::parse(ended.out);
    for (const auto& result : json["results"]) values[result["name"]] = result["value"];
    // How many frames there are in six seconds depends on who else has the machine.
    for (const char* name : {"visit.longest_frame_ms", "visit.upload_p99_ms", "visit.upload_longest_ms",
                             "visit.two_periods_percent", "visit.late_of_screen_percent"})
        EXPECT_TRUE(values.contains(name)) << name;
    EXPECT_GT(values["visit.resident_mb"], 10);
    EXPECT_GE(values["visit.late_of_screen_percent"], values["visit.late_frames_percent"]);
    EXPECT_GE(values["visit.resident_peak_mb"], values["visit.resident_mb"]);
    const std::string svg = contents_of(folder / "visit.svg");
    EXPECT_TRUE(is_well_formed(svg)) << svg.substr(0, 2000);
    const std::size_t points = svg.find("points=\"");
    ASSERT_NE(points, std::string::npos);
    EXPECT_GE(std::count(svg.begin() + static_cast<std::ptrdiff_t>(points), svg.end(), ','), 3)
        << "a point a frame, in three lines";
    EXPECT_EQ(count_of(contents_of(folder / "visit.html"), svg), 1U);
}

TEST(Doctor, LooksAtEveryPartAndSaysWhatToDo) {
    const TemporaryFolder folder;
    const Ended ended = run(program({"doctor", "--state", "state"}), folder);
    EXPECT_THAT(ended.status, testing::AnyOf(0, 3, 4)) << ended.err;
    for (const char* subject : {"gpu", "screen", "buttons", "state", "clock", "service"})
        EXPECT_NE(ended.out.find(subject), std::string::npos) << subject;
    EXPECT_FALSE(std::filesystem::exists(folder / "state")) << "the doctor only looks";
}

// A set-up with one thing wrong, and the exit status that says how bad that is.
struct SetUp {
    const char* name;
    void (*spoil)(const TemporaryFolder& folder);
    std::vector<std::string> only;
    int status;
    const char* said;
};
void PrintTo(const SetUp& set_up, std::ostream* os) { *os << set_up.name; }

class DoctorsStatus : public testing::TestWithParam<SetUp> {};

TEST_P(DoctorsStatus, IsAsBadAsTheWorstOfWhatWasLookedAt) {
    const TemporaryFolder folder;
    folder.write("quadrat.toml", contents_of(QUADRAT_SOURCE_DIR "/deploy/quadrat.toml"));
    std::filesystem::create_directory(folder / "state");
    GetParam().spoil(folder);
    std::vector<std::string> arguments{"doctor", "--config", "quadrat.toml", "--state", "state"};
    for (const std::string& part : GetParam().only) arguments.insert(arguments.end(), {"--only", part});
    const Ended ended = run(program(arguments), folder);
    EXPECT_EQ(ended.status, GetParam().status) << ended.out << ended.err;
    EXPECT_NE(ended.out.find(GetParam().said), std::string::npos) << ended.out;
}

INSTANTIATE_TEST_SUITE_P(
    Doctor, DoctorsStatus,
    testing::Values(
        SetUp{"NothingWrong", [](const TemporaryFolder&) {}, {"settings", "state", "service"}, 0, "can be used"},
        SetUp{"DamagedState",
              [](const TemporaryFolder& folder) { folder.write("state/quadrat.db", "no database any more"); },
              {"settings", "state", "service"},
              3,
              "is not a database any more"},
        SetUp{"ExhibitInSafeMode",
              [](const TemporaryFolder& folder) { folder.write("state/health.json", R"({"mode": "safe"})"); },
              {"settings", "state", "service"},
              3,
              "safe mode"},
        SetUp{"ExhibitThatStopped",
              [](const TemporaryFolder& folder) {
                  std::filesystem::last_write_time(
                      folder.write("state/health.json", "{}"),
                      std::filesystem::file_time_type::clock::now() - std::chrono::hours{1});
              },
              {"settings", "state", "service"},
              4,
              "the exhibit has stopped"},
        // Whatever the machine that it looks at is like.
        SetUp{"BrokenSettings",
              [](const TemporaryFolder& folder) { folder.write("quadrat.toml", "[visit]\nrounds = 900\n"); },
              {},
              4,
              "quadrat.toml:2: visit.rounds is 900"},
        SetUp{"NoSuchLine",
              [](const TemporaryFolder& folder) {
                  folder.write("quadrat.toml", "[buttons]\ninputs = [\"gpio:A=NO_SUCH_LINE\"]\n");
              },
              {},
              4,
              "NO_SUCH_LINE"}),
    [](const auto& set_up) { return std::string(set_up.param.name); });

TEST(Help, IsThereForEverySubcommand) {
    const TemporaryFolder folder;
    for (const char* command :
         {"run", "breed", "render", "export", "field", "lsystem", "bench", "doctor", "shot", "state"}) {
        const Ended ended = run(program({command, "--help"}), folder);
        EXPECT_EQ(ended.status, 0) << command;
        EXPECT_GT(ended.out.size(), 200U) << command;
    }
    EXPECT_EQ(run(program({"--help"}), folder).status, 0);
}

}  // namespace
