// SPDX-License-Identifier: Apache-2.0
// The whole beside a browser: the same four landscapes from the same cameras, in Chromium by three.js, which is given
// them as glTF with levels of detail, and by us, who grow them first. Both draw on the same rasteriser. The page draws
// less: no sky, water, houses or weather of ours, and no texture.
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/file.hpp"
#include "bench/peers/flight.hpp"
#include "bench/peers/page_scene.hpp"
#include "bench/peers/peers.hpp"
#include "benches/benches.hpp"
#include "display/display.hpp"
#include "nursery/growing.hpp"
#include "pictures/scene_export.hpp"
#include "support/process.hpp"

namespace quadrat::peers {
namespace {

using nlohmann::json;

nlohmann::json of(const glm::vec3& v) { return {v.x, v.y, v.z}; }

nursery::Scenes four_scenes() {
    nursery::Nursery nursery;
    const nursery::Landscapes four =
        nursery::landscapes_of(benches::random_candidates(kSeedOfFour), base::Seed{kSeedOfFour});
    nursery.want(nursery::wants_for(four, nursery::Stage::FullLight, nursery::Urgency::Awaited));
    nursery.wait();
    return nursery.find(four)->scenes;
}

// 0.glb to 3.glb and views.json, which says how tests/bench/browser/page.mjs shows them.
void write_four(const std::filesystem::path& folder, const Options& how) {
    const nursery::Scenes scenes = four_scenes();
    for (std::size_t i = 0; i < scenes.size(); ++i)
        base::write_file(
            folder / fmt::format("{}.glb", i),
            mesh::to_glb(how.is_as_exported ? pictures::scene_model(*scenes[i], pictures::Instances::Shared)
                                            : page_scene(*scenes[i])));
    const display::Size size = display::size_from(how.size, "--size");
    json views;
    views["size"] = {{"width", size.width}, {"height", size.height}};
    for (int n = 0; n < frames_of(how); ++n) {
        json frame = json::array();
        for (const auto& scene : scenes) {
            const scene::Camera camera = scene::camera_at(scene->track, seconds_of_frame(n));
            frame.push_back({{"eye_m", of(camera.eye_m)},
                             {"target_m", of(camera.target_m)},
                             {"vertical_fov_deg", camera.vertical_fov_deg}});
        }
        views["frames"].push_back(frame);
    }
    base::write_file(folder / "views.json", views.dump());
}

std::string last_line_of(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

json our_turn(const Options& how, const std::string& program, const tests::TemporaryFolder& folder) {
    std::vector<std::string> command{program, "--four-views", "--size", how.size};
    if (how.is_quick) command.emplace_back("--quick");
    const std::chrono::duration<double, std::milli> begun = std::chrono::steady_clock::now().time_since_epoch();
    const tests::Ended ended = tests::run(command, folder);
    if (ended.status != 0) throw std::runtime_error("our own views: " + last_line_of(ended.err));
    json told = json::parse(ended.out);
    told["first_frame_ms"] = told.at("first_seen_ms").get<double>() - begun.count();
    return told;
}

// Null, and why, where Chromium or what it needs is missing or does not draw.
json their_turn(const std::filesystem::path& scenes, const tests::TemporaryFolder& folder, std::string& why) {
    const tests::Ended ended = tests::run({QUADRAT_PEERS_BROWSER, scenes.string()}, folder);
    if (ended.status == 0) return json::parse(last_line_of(ended.out));
    why = last_line_of(ended.status == 77 ? ended.out : ended.err);
    return nullptr;
}

struct Compared {
    const char* name;
    const char* unit;
    const char* ours;
    const char* theirs;
    double goal;
    const char* note;
};

constexpr Compared kRows[] = {
    {"frame_alpha_1", "ms", "frame_alpha_1_ms", "frame_ms", 0.2, "four views, detail 1"},
    {"frame_alpha_02", "ms", "frame_alpha_02_ms", "frame_ms", 0.1,
     "four views, detail 0.2; the page has but one detail"},
    {"memory", "MB", "memory_mb", "memory_mb", 0.4,
     "at its peak; of Chromium all processes, pages shared counted once"},
    {"first_frame", "ms", "first_frame_ms", "first_frame_ms", 0.4,
     "from the start of the program; we grow, the page loads"},
    {"generation", "ms", "grown_ms", "built_ms", 0.35, "to four landscapes in their own light, from nothing"}};

}  // namespace

std::vector<Row> whole(const Options& how, const std::string& program) {
    const tests::TemporaryFolder folder;
    const std::filesystem::path scenes = how.folder.empty() ? folder.path() : std::filesystem::absolute(how.folder);
    std::filesystem::create_directories(scenes);
    write_four(scenes, how);
    std::vector<json> ours;
    std::vector<json> theirs;
    std::string why;
    for (int turn = 0; turn < how.turns; ++turn) {
        std::cerr << fmt::format("  turn {} of {}\n", turn + 1, how.turns);
        ours.push_back(our_turn(how, program, folder));
        if (why.empty()) theirs.push_back(their_turn(scenes, folder, why));
    }
    std::string against =
        how.is_as_exported ? "Chromium with three.js, all in the finest level" : "Chromium with three.js";
    if (why.empty())
        against +=
            fmt::format(" on {}, {:.1f} million triangles a frame", theirs.back().at("renderer").get<std::string>(),
                        theirs.back().at("triangles").get<double>() / 1e6);
    std::vector<Row> rows;
    for (const Compared& c : kRows) {
        Row& row = rows.emplace_back(Row{c.name, c.unit, against, c.goal, {}, c.note, why});
        for (const json& turn : ours) row.turns.ours.push_back(turn.at(c.ours));
        if (!why.empty()) continue;
        for (const json& turn : theirs) row.turns.yardstick.push_back(turn.at(c.theirs));
    }
    return rows;
}

}  // namespace quadrat::peers
