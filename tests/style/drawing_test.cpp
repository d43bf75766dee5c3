// SPDX-License-Identifier: Apache-2.0
// ARCHITECTURE.svg is drawn from layers.txt, so it shows the rules that the other tests of this folder check. After a
// change of the table, draw it anew with QUADRAT_MAKE_GOLDENS=1 in the environment.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>

#include "layer_table.hpp"

namespace {

using quadrat::tests::LayerTable;
using Names = std::vector<std::string>;

constexpr int kBoxWidth = 112;
constexpr int kBoxHeight = 40;
constexpr int kColumn = 128;
constexpr int kRow = 92;
constexpr int kMargin = 24;
constexpr int kLegend = 64;

std::string short_name(const std::string& room) { return room.starts_with("app/") ? room.substr(4) : room; }

// Rooms in rooms are drawn as one; main.cpp is none.
bool is_drawn(const std::string& room) {
    return short_name(room).find('/') == std::string::npos && !room.ends_with(".cpp");
}

class House {
  public:
    explicit House(const LayerTable& table) : table_(table) {
        for (const auto& [room, allowed] : table.rooms)
            if (is_drawn(room)) rows_.resize(std::max(rows_.size(), level(room) + 1));
        for (const auto& [room, allowed] : table.rooms)
            if (is_drawn(room)) rows_[level(room)].push_back(room);
        for (const Names& row : rows_) columns_ = std::max(columns_, row.size());
    }

    std::string svg() const {
        const int width = 2 * kMargin + static_cast<int>(columns_) * kColumn;
        const int height = 2 * kMargin + kLegend + static_cast<int>(rows_.size()) * kRow;
        std::string out =
            fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" )"
                        R"(font-family="Lato, Helvetica, sans-serif" font-size="14">)"
                        "\n"
                        R"(<rect width="100%" height="100%" fill="#ffffff"/>)"
                        "\n",
                        width, height);
        for (const Names& row : rows_)
            for (const std::string& room : row)
                for (const std::string& other : nearest(room)) out += arrow(room, other);
        for (const Names& row : rows_)
            for (const std::string& room : row) out += box(room);
        int line = 0;
        for (const auto& [path, rooms] : table_.paths) out += legend(path, line++, height);
        return out + "</svg>\n";
    }

  private:
    struct Place {
        int x, y;  // of the upper left corner
    };

    std::size_t level(const std::string& room) const {
        std::size_t height = 0;
        for (const std::string& other : table_.rooms.at(room))
            if (is_drawn(other)) height = std::max(height, level(other) + 1);
        return height;
    }
    std::set<std::string> below(const std::string& room) const {
        std::set<std::string> all;
        for (const std::string& other : table_.rooms.at(room)) {
            if (!is_drawn(other)) continue;
            all.insert(other);
            all.merge(below(other));
        }
        return all;
    }
    // Those that it does not reach through another.
    Names nearest(const std::string& room) const {
        Names near;
        const Names& allowed = table_.rooms.at(room);
        for (const std::string& other : allowed) {
            const bool is_through_another = std::ranges::any_of(allowed, [&](const std::string& between) {
                return is_drawn(between) && below(between).contains(other);
            });
            if (is_drawn(other) && !is_through_another) near.push_back(other);
        }
        return near;
    }
    Place place(const std::string& room) const {
        const std::size_t at = level(room);
        const Names& row = rows_[at];
        const auto column = static_cast<int>(std::ranges::find(row, room) - row.begin());
        const int indent = (static_cast<int>(columns_) - static_cast<int>(row.size())) * kColumn / 2;
        return {kMargin + indent + column * kColumn, kMargin + static_cast<int>(rows_.size() - 1 - at) * kRow};
    }
    std::string arrow(const std::string& from, const std::string& to) const {
        const Place a = place(from);
        const Place b = place(to);
        const int x1 = a.x + kBoxWidth / 2;
        const int x2 = b.x + kBoxWidth / 2;
        const int y1 = a.y + kBoxHeight;
        return fmt::format(R"(<path d="M{} {} C{} {} {} {} {} {}" fill="none" stroke="#b8bec4"/>)"
                           "\n",
                           x1, y1, x1, y1 + 30, x2, b.y - 30, x2, b.y);
    }
    std::string box(const std::string& room) const {
        const Place at = place(room);
        std::string out =
            fmt::format(R"(<rect x="{}" y="{}" width="{}" height="{}" rx="6" fill="#f4f6f2" stroke="#5a6a5a"/>)"
                        R"(<text x="{}" y="{}" text-anchor="middle">{}</text>)"
                        "\n",
                        at.x, at.y, kBoxWidth, kBoxHeight, at.x + kBoxWidth / 2, at.y + 25, short_name(room));
        int line = 0;
        for (const auto& [path, rooms] : table_.paths) {
            const auto found = std::ranges::find(rooms, room);
            if (found != rooms.end())
                out += badge(at.x + (line == 0 ? 0 : kBoxWidth), at.y, line, std::to_string(found - rooms.begin() + 1));
            ++line;
        }
        return out;
    }
    static std::string badge(int x, int y, int line, const std::string& text) {
        constexpr const char* kColours[] = {"#0072b2", "#d55e00"};  // Okabe & Ito
        return fmt::format(R"(<circle cx="{}" cy="{}" r="10" fill="{}"/>)"
                           R"(<text x="{}" y="{}" text-anchor="middle" fill="#ffffff" font-size="12">{}</text>)"
                           "\n",
                           x, y, kColours[line % 2], x, y + 4, text);
    }
    static std::string legend(const std::string& path, int line, int height) {
        const int y = height - kLegend + 10 + line * 26;
        return badge(kMargin + 10, y, line, "1") + fmt::format(R"(<text x="{}" y="{}">from {}, room by room</text>)"
                                                               "\n",
                                                               kMargin + 28, y + 5, path);
    }

    const LayerTable& table_;
    std::vector<Names> rows_;  // from the lowest
    std::size_t columns_ = 0;
};

TEST(Drawing, ShowsTheTable) {
    const LayerTable table = quadrat::tests::read_layers();
    const std::string drawn = House(table).svg();
    constexpr const char* kFile = QUADRAT_SOURCE_DIR "/ARCHITECTURE.svg";
    if (std::getenv("QUADRAT_MAKE_GOLDENS") != nullptr) std::ofstream(kFile) << drawn;
    std::ifstream file(kFile);
    const std::string kept{std::istreambuf_iterator<char>(file), {}};
    EXPECT_TRUE(kept == drawn) << "layers.txt has changed: draw ARCHITECTURE.svg anew (see the top of this file)";
}

TEST(Drawing, EachPathPassesARoomOnce) {
    const LayerTable table = quadrat::tests::read_layers();
    ASSERT_FALSE(table.paths.empty());
    for (const auto& [path, rooms] : table.paths) {
        EXPECT_EQ(std::set<std::string>(rooms.begin(), rooms.end()).size(), rooms.size()) << path;
        for (const std::string& room : rooms) EXPECT_TRUE(table.rooms.contains(room)) << path << ": " << room;
    }
}

}  // namespace
