// SPDX-License-Identifier: Apache-2.0
// Reads layers.txt and checks every include of every source file against it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "support/source_tree.hpp"

namespace {

using quadrat::tests::SourceFile;

struct Layers {
    std::map<std::string, std::vector<std::string>> rooms;
    std::map<std::string, std::vector<std::string>> system;
};

Layers read_layers() {
    Layers layers;
    std::ifstream file(QUADRAT_SOURCE_DIR "/tests/style/layers.txt");
    auto* table = &layers.rooms;
    for (std::string line; std::getline(file, line);) {
        if (line == "[system]") table = &layers.system;
        const auto colon = line.find(':');
        if (line.empty() || line[0] == '#' || colon == std::string::npos) continue;
        std::istringstream names(line.substr(colon + 1));
        auto& allowed = (*table)[line.substr(0, colon)];
        for (std::string name; names >> name;) allowed.push_back(name);
    }
    return layers;
}

bool lies_in(const std::string& path, const std::string& folder) {
    return path == folder || path.starts_with(folder + "/");
}

std::string room_of(const Layers& layers, const std::string& path) {
    std::string best;
    for (const auto& [room, allowed] : layers.rooms)
        if (lies_in(path, room) && room.size() > best.size()) best = room;
    return best;
}

struct Include {
    std::string name;
    bool is_ours;
};

std::vector<Include> includes_of(const SourceFile& file) {
    static const std::regex directive(R"(^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"])", std::regex::multiline);
    std::vector<Include> found;
    for (std::sregex_iterator it(file.text.begin(), file.text.end(), directive), end; it != end; ++it)
        found.push_back({(*it)[2].str(), (*it)[1].str() == "\""});
    return found;
}

// Includes are written from app/ or from the repository's root.
std::string path_of(const std::string& name) {
    namespace fs = std::filesystem;
    const fs::path root = QUADRAT_SOURCE_DIR;
    if (fs::exists(root / "app" / name)) return "app/" + name;
    return name;
}

std::vector<SourceFile> our_sources() {
    return quadrat::tests::source_files({"app", "firmware-io"}, {".hpp", ".cpp", ".inc", ".h"});
}

TEST(Layers, EveryFileLiesInARoomOfTheTable) {
    const Layers layers = read_layers();
    ASSERT_GT(layers.rooms.size(), 10U);
    for (const SourceFile& file : our_sources()) EXPECT_NE(room_of(layers, file.path), "") << file.path;
}

TEST(Layers, NobodyIncludesARoomThatTheTableDoesNotAllow) {
    const Layers layers = read_layers();
    std::size_t checked = 0;
    for (const SourceFile& file : our_sources()) {
        const std::string room = room_of(layers, file.path);
        for (const Include& include : includes_of(file)) {
            if (!include.is_ours) continue;
            const std::string target = path_of(include.name);
            bool is_allowed = lies_in(target, room);
            for (const std::string& allowed : layers.rooms.at(room))
                is_allowed = is_allowed || lies_in(target, allowed);
            EXPECT_TRUE(is_allowed) << file.path << " includes " << include.name << ", which " << room << " may not";
            ++checked;
        }
    }
    EXPECT_GT(checked, 50U);
}

TEST(Layers, SystemHeadersOfADeviceStayInItsRoom) {
    const Layers layers = read_layers();
    ASSERT_FALSE(layers.system.empty());
    for (const SourceFile& file : our_sources()) {
        for (const Include& include : includes_of(file)) {
            for (const auto& [prefix, rooms] : layers.system) {
                if (include.is_ours || !include.name.starts_with(prefix)) continue;
                bool is_allowed = false;
                for (const std::string& room : rooms) is_allowed = is_allowed || lies_in(file.path, room);
                EXPECT_TRUE(is_allowed) << file.path << " includes <" << include.name << ">";
            }
        }
    }
}

// Time enters as an argument: the clock is read in the kiosk, and by a display that waits for its own flips.
TEST(Layers, OnlyTheKioskAndTheDisplayReadAClock) {
    for (const SourceFile& file : our_sources()) {
        if (lies_in(file.path, "app/kiosk") || lies_in(file.path, "app/display")) continue;
        EXPECT_EQ(file.text.find("_clock::now"), std::string::npos) << file.path;
        EXPECT_EQ(file.text.find("random_device"), std::string::npos) << file.path;
    }
}

}  // namespace
