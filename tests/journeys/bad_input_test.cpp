// SPDX-License-Identifier: Apache-2.0
// Bad input: one line on stderr that names the place, exit status 2, and nothing overwritten.
#include <gtest/gtest.h>

#include <filesystem>

#include "journeys/quadrat_program.hpp"

namespace {

using namespace quadrat::tests;

struct BadInput {
    const char* name;
    std::vector<std::string> arguments;
    std::vector<std::string> said;  // all of these stand in the one line
};

void PrintTo(const BadInput& bad, std::ostream* os) { *os << bad.name; }

class Refused : public testing::TestWithParam<BadInput> {};

void make_inputs(const TemporaryFolder& folder) {
    folder.write("bad.script", "at 2s press A\nat 3s prod B\n");
    folder.write("bad.toml", "[visit]\nrounds = \"six\"\n");
    folder.write("unknown.toml", "[visit]\nround = 6\n");
    folder.write("mole.toml", "[picture]\nground = \"mole\"\n");
    folder.write("broken.toml", "[visit\nrounds = 6\n");
    folder.write("broken.json", "{\"quadrat\":\"scene\",\n \"version\":1,,}");
    folder.write("unknown.json", R"({"quadrat":"scene","version":1,"parameters":{"tree.colour":1}})");
    folder.write("range.json", R"({"quadrat":"scene","version":1,"parameters":{"tree.branch_angle_deg":200}})");
    folder.write("version.json", R"({"quadrat":"scene","version":99,"parameters":{}})");
    folder.write("bare.png", std::string("\x89PNG\r\n\x1a\n", 8));
    folder.write(
        "nice.json",
        R"({"quadrat":"described","version":1,"aspect":"land","scenes":[{"words":{"nice":1},"parameters":{}}]})");
    folder.write(
        "loud.json",
        R"({"quadrat":"described","version":1,"aspect":"land","scenes":[{"words":{"wet":1.5},"parameters":{}}]})");
    folder.write(
        "few.json",
        R"({"quadrat":"own word","version":1,"name":"Irish","aspect":"land","scenes":[{"value":1,"words":{}}]})");
    folder.write("map.json", R"({"quadrat":"word map","version":3,"curator":[],"visitors":[]})");
    folder.write("nan.txt", "# heights\n3 4 nan\n");
    folder.write("far.txt", "600 3 0.5\n");
    folder.write("up.txt", "river 10 10 0 20 20 1\n");
    folder.write("out.png", "keep me");
    folder.write("out.obj", "keep me");
}

TEST_P(Refused, InOneLineThatNamesThePlaceAndNothingIsOverwritten) {
    const TemporaryFolder folder;
    make_inputs(folder);
    const Ended ended = run(program(GetParam().arguments), folder);
    EXPECT_EQ(ended.status, 2) << ended.err;
    const auto lines = lines_of(ended.err);
    ASSERT_FALSE(lines.empty());
    EXPECT_TRUE(lines.back().starts_with("quadrat: ")) << ended.err;
    // Before it, at most what the log said while the program started.
    for (std::size_t i = 0; i + 1 < lines.size(); ++i)
        EXPECT_NE(lines[i].find(" info "), std::string::npos) << lines[i];
    for (const std::string& part : GetParam().said)
        EXPECT_NE(lines.back().find(part), std::string::npos) << lines.back() << "\n does not say: " << part;
    EXPECT_EQ(contents_of(folder / "out.png"), "keep me");
    EXPECT_EQ(contents_of(folder / "out.obj"), "keep me");
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        EXPECT_FALSE(entry.path().filename().string().starts_with(".out")) << "left behind: " << entry.path();
}

const std::vector<std::string> kRun{"run", "--display", "headless", "--size", "160x90", "--state", "state"};

std::vector<std::string> run_with(std::vector<std::string> more) {
    more.insert(more.begin(), kRun.begin(), kRun.end());
    return more;
}

INSTANTIATE_TEST_SUITE_P(
    BadInput, Refused,
    testing::Values(
        BadInput{"Script", run_with({"--input", "script:bad.script"}), {"bad.script:2", "prod"}},
        BadInput{"MissingScript", run_with({"--input", "script:none.script"}), {"none.script"}},
        BadInput{"InputSpec", run_with({"--input", "telepathy:"}), {"telepathy"}},
        BadInput{
            "ConfigurationType", run_with({"--config", "bad.toml"}), {"bad.toml:2", "visit.rounds", "whole number"}},
        BadInput{
            "ConfigurationKey", run_with({"--config", "unknown.toml"}), {"unknown.toml:2", "visit.round", "rounds"}},
        BadInput{"ConfigurationSyntax", run_with({"--config", "broken.toml"}), {"broken.toml:1"}},
        BadInput{"MissingConfiguration", run_with({"--config", "none.toml"}), {"none.toml"}},
        BadInput{"Size", {"run", "--display", "headless", "--size", "12x"}, {"12x"}},
        BadInput{"RunGround", run_with({"--ground", "mole"}), {"--ground", "mole", "blocks", "roam"}},
        BadInput{"ConfigurationGround", run_with({"--config", "mole.toml"}), {"mole.toml:2", "picture.ground", "roam"}},
        BadInput{"RenderGround",
                 {"render", "seed:1", "-o", "out.png", "--ground", "mole"},
                 {"--ground", "mole", "blocks", "roam"}},
        BadInput{"Rounds", run_with({"--rounds", "0"}), {"rounds"}},
        BadInput{"SceneSyntax", {"render", "broken.json", "-o", "out.png"}, {"broken.json:2"}},
        BadInput{"SceneParameter", {"render", "unknown.json", "-o", "out.png"}, {"unknown.json", "tree.colour"}},
        BadInput{"SceneRange", {"render", "range.json", "-o", "out.png"}, {"tree.branch_angle_deg", "200", "60"}},
        BadInput{"SceneVersion", {"render", "version.json", "-o", "out.png"}, {"version.json", "99", "1"}},
        BadInput{"SceneSeed", {"render", "seed:x", "-o", "out.png"}, {"seed:x"}},
        BadInput{"BrokenPicture", {"render", "bare.png", "-o", "out.png"}, {"bare.png"}},
        BadInput{"MissingScene", {"render", "none.json", "-o", "out.png"}, {"none.json"}},
        BadInput{"Camera", {"render", "seed:1", "-o", "out.png", "--camera", "up"}, {"--camera up"}},
        BadInput{
            "PictureFormat", {"render", "seed:1", "-o", "out.xyz", "--size", "64x64"}, {"out.xyz", ".png or .exr"}},
        BadInput{"PictureFolder", {"render", "seed:1", "-o", "none/out.png"}, {"none/out.png", "no folder none"}},
        BadInput{"ExportFormat", {"export", "seed:1", "-o", "out.stl", "--what", "tree"}, {"out.stl", ".obj"}},
        BadInput{"ExportWhat", {"export", "seed:1", "-o", "out.obj", "--what", "cow"}, {"cow"}},
        BadInput{"FieldMethod", {"field", "marble", "-o", "out.png"}, {"marble", "diamond-square"}},
        BadInput{"FieldSize", {"field", "fbm", "-o", "out.png", "--size", "8194"}, {"8194", "8193"}},
        BadInput{"FieldNoSize", {"field", "fbm", "-o", "out.png", "--size", "0"}, {"size is 0"}},
        BadInput{"FieldEnding", {"field", "fbm", "-o", "out.obj"}, {"out.obj", ".exr", ".png"}},
        BadInput{"FieldWindow", {"field", "fbm", "-o", "out.png", "--window", "1,2,3"}, {"--window 1,2,3"}},
        BadInput{"FieldWindowOutside", {"field", "fbm", "-o", "out.png", "--window", "500,0,20,20"}, {"500,0,20,20"}},
        BadInput{"FieldFixed", {"field", "fbm", "-o", "out.png", "--fix", "nan.txt"}, {"nan.txt:2", "nan"}},
        BadInput{"FieldFixedOutside", {"field", "fbm", "-o", "out.png", "--fix", "far.txt"}, {"600 3", "513"}},
        BadInput{"FieldLines", {"field", "fbm", "-o", "out.png", "--lines", "up.txt"}, {"rises", "20 20"}},
        BadInput{"FieldMask", {"field", "fbm", "-o", "out.png", "--mask", "bare.png"}, {"bare.png"}},
        BadInput{"FieldMaskMissing", {"field", "fbm", "-o", "out.png", "--mask", "none.tif"}, {"none.tif"}},
        BadInput{"FieldWith", {"field", "island", "-o", "out.png", "--with", "bare.png"}, {"island", "fbm"}},
        BadInput{"FieldWithMissing", {"field", "fbm", "-o", "out.png", "--with", "none.png"}, {"none.png"}},
        BadInput{"FieldSearchWithoutMask", {"field", "fbm", "-o", "out.png", "--search", "0.1"}, {"--mask"}},
        BadInput{"BreedGenome", {"breed", "--stdio", "--genome", "mouse"}, {"mouse"}},
        BadInput{"BreedLock", {"breed", "--stdio", "--lock", "sea"}, {"sea"}},
        BadInput{"BreedRate", {"breed", "--stdio", "--learning-rate", "2"}, {"2"}},
        BadInput{"WordsUnknown",
                 {"words", "--state", ".", "train", "nice.json"},
                 {"nice.json", "scenes[0].words", "nice", "wet"}},
        BadInput{"WordsOutside",
                 {"words", "--state", ".", "train", "loud.json"},
                 {"loud.json", "wet", "1.5", "from -1 to 1"}},
        BadInput{"WordsVersion", {"words", "--state", ".", "train", "map.json"}, {"map.json", "version is 3"}},
        BadInput{"WordsMissing", {"words", "--state", ".", "train", "none.json"}, {"none.json"}},
        BadInput{"WordsNoStateToTrain", {"words", "--state", "state", "train"}, {"state", "no such folder", "--state"}},
        BadInput{"WordsNoState", {"words", "--state", "state", "forget"}, {"state", "no such folder", "--state"}},
        BadInput{"WordsNothingToExport", {"words", "--state", "state", "export", "-o", "out.json"}, {"no such folder"}},
        BadInput{"OwnWordTooFew", {"words", "own", "few.json"}, {"few.json", "at least 10", "it has 1"}},
        BadInput{"OwnWordInBreed", {"breed", "--stdio", "--own-word", "few.json"}, {"few.json", "at least 10"}},
        BadInput{"OwnWordValue", {"words", "own", "few.json", "--value", "2"}, {"--value"}},
        BadInput{"Subcommand", {"dance"}, {"dance"}}, BadInput{"NoSubcommand", {}, {"subcommand"}}),
    [](const auto& bad) { return std::string(bad.param.name); });

}  // namespace
