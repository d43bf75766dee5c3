// SPDX-License-Identifier: Apache-2.0
// Reads layers.txt and checks every include of every source file against it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "layer_table.hpp"
#include "support/source_tree.hpp"

namespace {

using quadrat::tests::SourceFile;

using Layers = quadrat::tests::LayerTable;
using quadrat::tests::read_layers;

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

// A reader begins there. Rooms in rooms are told of with the room that they lie in.
TEST(Layers, EveryRoomSaysInOneHeaderWhatLivesThere) {
    const Layers layers = read_layers();
    const auto headers = quadrat::tests::source_files({"app", "firmware-io"}, {".hpp"});
    for (const auto& [room, allowed] : layers.rooms) {
        const std::string name = room.starts_with("app/") ? room.substr(4) : room;
        if (name == "shaders" || name == "main.cpp" || name.find('/') != std::string::npos) continue;
        const auto tells = [&](const SourceFile& header) {
            return room_of(layers, header.path) == room && header.text.find("\n// The room `" + name + "`: ") < 100;
        };
        EXPECT_EQ(std::ranges::count_if(headers, tells), 1) << room;
    }
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
                bool is_excepted = false;
                for (const std::string& room : rooms) {
                    is_allowed = is_allowed || lies_in(file.path, room);
                    is_excepted = is_excepted || (room[0] == '-' && lies_in(file.path, room.substr(1)));
                }
                EXPECT_TRUE(is_allowed && !is_excepted) << file.path << " includes <" << include.name << ">";
            }
        }
    }
}

// Time enters as an argument: who reads a clock, or chance, is listed.
TEST(Layers, AClockIsReadOnlyWhereTheTableAllowsIt) {
    const Layers layers = read_layers();
    ASSERT_TRUE(layers.clocks.contains("clock"));
    for (const SourceFile& file : our_sources()) {
        const auto reads = [&](const char* what) { return file.text.find(what) != std::string::npos; };
        if (!reads("_clock::now") && !reads("random_device")) continue;
        EXPECT_TRUE(std::ranges::any_of(layers.clocks.at("clock"), [&](const auto& r) {
            return lies_in(file.path, r);
        })) << file.path;
    }
}

TEST(Layers, EveryFolderOfTheTableExists) {
    const Layers layers = read_layers();
    const auto expect_there = [](const std::string& folder) {
        EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(QUADRAT_SOURCE_DIR) / folder)) << folder;
    };
    for (const auto* table : {&layers.rooms, &layers.system, &layers.clocks, &layers.paths}) {
        for (const auto& [name, folders] : *table) {
            if (table == &layers.rooms) expect_there(name);
            for (const std::string& folder : folders) expect_there(folder.substr(folder[0] == '-' ? 1 : 0));
        }
    }
}

// A room that includes another, however far away, is not included by it.
TEST(Layers, NoArrowPointsUpward) {
    const Layers layers = read_layers();
    std::map<std::string, std::set<std::string>> below;
    const std::function<const std::set<std::string>&(const std::string&, int)> reach = [&](const std::string& room,
                                                                                           int depth) -> const auto& {
        if (below.contains(room) || depth > 50) return below[room];
        std::set<std::string> all;
        for (const std::string& other : layers.rooms.at(room)) {
            all.insert(other);
            for (const std::string& further : reach(other, depth + 1)) all.insert(further);
        }
        return below[room] = all;
    };
    for (const auto& [room, allowed] : layers.rooms)
        EXPECT_FALSE(reach(room, 0).contains(room)) << room << " can be reached from itself";
}

}  // namespace
