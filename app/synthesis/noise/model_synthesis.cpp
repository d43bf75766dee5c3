// SPDX-License-Identifier: Apache-2.0
// Merrell, "Example-based model synthesis", 2007, and Merrell & Manocha, "Model synthesis: a general procedural
// modeling algorithm", 2011: from a box that is right already, small parts are made anew, each from all that its
// surroundings allow; what can no longer stand beside what was chosen is struck out (arc consistency, Mackworth 1977),
// and a part that comes to nothing stays as it was.
#include "synthesis/noise/model_synthesis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace quadrat::synthesis::noise {
namespace {

using Kinds = std::uint32_t;  // a bit a kind of tile

constexpr std::array<glm::ivec3, 6> kSides{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

// What the example shows of who stands beside whom.
struct Rules {
    std::string kinds;  // the first is air, the second the ground
    std::vector<float> share;
    std::array<std::array<Kinds, 32>, kSides.size()> beside{};  // of a side and a kind, those that may stand there

    explicit Rules(const Tiles& example) : kinds{Tiles::kAir, Tiles::kGround}, share(2, 0.0F) {
        for (const char tile : example.cells) {
            const std::size_t k = number(tile);
            if (k == kinds.size()) {
                kinds.push_back(tile);
                share.push_back(0);
            }
            share[k] += 1;
        }
        assert(kinds.size() <= 32);
        for (std::size_t side = 0; side + 2 < kSides.size(); ++side) {
            allow(side, 0, 0);
            allow(side, 1, 1);
        }
        allow(4, 0, 0);
        allow(4, 1, 0);
        // One cell beyond the example on every side.
        for (int z = -1; z <= example.size.z; ++z)
            for (int y = -1; y <= example.size.y; ++y)
                for (int x = -1; x <= example.size.x; ++x)
                    for (const std::size_t side : {0U, 2U, 4U}) {
                        const glm::ivec3 here{x, y, z};
                        allow(side, number(example.at(here)), number(example.at(here + kSides[side])));
                    }
    }
    std::size_t number(char tile) const { return std::min(kinds.find(tile), kinds.size()); }
    void allow(std::size_t side, std::size_t here, std::size_t there) {
        beside[side][here] |= 1U << there;
        beside[side ^ 1U][there] |= 1U << here;
    }
    Kinds all() const { return kinds.size() == 32 ? ~0U : (1U << kinds.size()) - 1U; }
    Kinds beside_any(std::size_t side, Kinds here) const {
        Kinds some = 0;
        for (; here != 0; here &= here - 1) some |= beside[side][static_cast<std::size_t>(std::countr_zero(here))];
        return some;
    }
};

// A part that is made anew: what may still stand in each of its cells.
class Part {
  public:
    Part(const Rules& rules, const Tiles& tiles, glm::ivec3 from, glm::ivec3 to)
        : rules_(rules), tiles_(tiles), from_(from), size_(to - from) {
        may_.assign(static_cast<std::size_t>(size_.x) * size_.y * size_.z, rules.all() & ~2U);
    }

    // Whether something can stand everywhere; if so, tiles has it.
    bool make(Tiles& tiles, const std::vector<float>& weights, base::RandomStream& random) {
        for (std::size_t i = 0; i < may_.size(); ++i)
            if (!strike_out(cell(i))) return false;
        if (!settle()) return false;
        for (;;) {
            const std::size_t i = most_certain(weights, random);
            if (i == may_.size()) break;
            may_[i] = 1U << chosen(may_[i], weights, random);
            around(cell(i));
            if (!settle()) return false;
        }
        for (std::size_t i = 0; i < may_.size(); ++i)
            tiles.cell(cell(i)) = rules_.kinds[static_cast<std::size_t>(std::countr_zero(may_[i]))];
        return true;
    }

  private:
    glm::ivec3 cell(std::size_t i) const {
        const int k = static_cast<int>(i);
        return from_ + glm::ivec3{k % size_.x, k / size_.x % size_.y, k / size_.x / size_.y};
    }
    bool is_part(glm::ivec3 at) const {
        const glm::ivec3 in = at - from_;
        return in.x >= 0 && in.y >= 0 && in.z >= 0 && in.x < size_.x && in.y < size_.y && in.z < size_.z;
    }
    std::size_t index(glm::ivec3 at) const {
        const glm::ivec3 in = at - from_;
        return static_cast<std::size_t>((in.z * size_.y + in.y) * size_.x + in.x);
    }
    Kinds may_be(glm::ivec3 at) const { return is_part(at) ? may_[index(at)] : 1U << rules_.number(tiles_.at(at)); }
    // Leaves what every neighbour allows; false where that is nothing.
    bool strike_out(glm::ivec3 at) {
        Kinds& here = may_[index(at)];
        const Kinds before = here;
        for (std::size_t side = 0; side < kSides.size(); ++side)
            here &= rules_.beside_any(side ^ 1U, may_be(at + kSides[side]));
        if (here != before) around(at);
        return here != 0;
    }
    void around(glm::ivec3 at) {
        for (const glm::ivec3& side : kSides)
            if (is_part(at + side)) waiting_.push_back(at + side);
    }
    bool settle() {
        while (!waiting_.empty()) {
            const glm::ivec3 at = waiting_.back();
            waiting_.pop_back();
            if (!strike_out(at)) return false;
        }
        return true;
    }
    // The cell with the least left to choose; the end where all are chosen.
    std::size_t most_certain(const std::vector<float>& weights, base::RandomStream& random) const {
        std::size_t best = may_.size();
        float least = std::numeric_limits<float>::max();
        for (std::size_t i = 0; i < may_.size(); ++i) {
            if (std::popcount(may_[i]) < 2) continue;
            float sum = 0;
            float sum_of_logs = 0;
            for (Kinds k = may_[i]; k != 0; k &= k - 1) {
                const float w = weights[static_cast<std::size_t>(std::countr_zero(k))];
                sum += w;
                sum_of_logs += w * std::log(w);
            }
            const float doubt = std::log(sum) - sum_of_logs / sum + 0.01F * random.unit_f();
            if (doubt >= least) continue;
            least = doubt;
            best = i;
        }
        return best;
    }
    static int chosen(Kinds kinds, const std::vector<float>& weights, base::RandomStream& random) {
        float sum = 0;
        for (Kinds k = kinds; k != 0; k &= k - 1) sum += weights[static_cast<std::size_t>(std::countr_zero(k))];
        float at = sum * random.unit_f();
        for (Kinds k = kinds; k != 0; k &= k - 1) {
            const int kind = std::countr_zero(k);
            at -= weights[static_cast<std::size_t>(kind)];
            if (at < 0 || (k & (k - 1)) == 0) return kind;
        }
        return 0;
    }

    const Rules& rules_;
    const Tiles& tiles_;
    glm::ivec3 from_;
    glm::ivec3 size_;
    std::vector<Kinds> may_;
    std::vector<glm::ivec3> waiting_;
};

// Reads layers row by row.
class TilesText {
  public:
    explicit TilesText(const std::string& name) : name_(name) {}

    void read_line(std::string_view words) {
        ++line_;
        if (!words.empty() && words.back() == '\r') words.remove_suffix(1);
        if (!words.empty() && words.front() == ';') return;
        if (words.empty()) return end_layer();
        if (tiles_.size.x == 0) tiles_.size.x = static_cast<int>(words.size());
        if (static_cast<int>(words.size()) != tiles_.size.x)
            refuse(words.size(), fmt::format("a row of {} tiles; the first has {}", words.size(), tiles_.size.x));
        if (tiles_.size.x > kMostTilesASide || ++row_ > kMostTilesASide)
            refuse(kMostTilesASide, fmt::format("more than {} tiles a side", kMostTilesASide));
        for (std::size_t column = 0; column < words.size(); ++column) read_tile(words[column], column);
        tiles_.cells.append(words);
    }
    Tiles whole() {
        end_layer();
        if (tiles_.size.z == 0) refuse(0, "no tiles; write rows of characters, '.' for air");
        return std::move(tiles_);
    }

  private:
    [[noreturn]] void refuse(std::size_t column, const std::string& why) const {
        throw base::InputError(fmt::format("{}:{}:{}: {}", name_, line_, column + 1, why));
    }
    void read_tile(char tile, std::size_t column) {
        if (tile <= ' ' || tile > '~' || tile == Tiles::kGround || tile == ';')
            refuse(column, "a tile is a printable character, no space, no underscore and no semicolon");
        if (kinds_.find(tile) == std::string::npos) kinds_.push_back(tile);
        if (kinds_.size() > kMostKindsOfTiles)
            refuse(column, fmt::format("more than {} kinds of tiles", kMostKindsOfTiles));
    }
    void end_layer() {
        if (row_ == 0) return;
        if (tiles_.size.z == 0) tiles_.size.y = row_;
        if (row_ != tiles_.size.y) refuse(0, fmt::format("a layer of {} rows; the first has {}", row_, tiles_.size.y));
        if (++tiles_.size.z > kMostTilesASide) refuse(0, fmt::format("more than {} layers", kMostTilesASide));
        row_ = 0;
    }
    const std::string& name_;
    Tiles tiles_;
    int line_ = 0;
    int row_ = 0;  // of the layer at hand
    std::string kinds_{Tiles::kAir};
};

}  // namespace

bool Tiles::is_inside(glm::ivec3 cell) const {
    return cell.x >= 0 && cell.y >= 0 && cell.z >= 0 && cell.x < size.x && cell.y < size.y && cell.z < size.z;
}

std::size_t Tiles::index(glm::ivec3 cell) const {
    return static_cast<std::size_t>((cell.z * size.y + cell.y) * size.x + cell.x);
}

char Tiles::at(glm::ivec3 cell) const {
    if (cell.z < 0) return kGround;
    return is_inside(cell) ? cells[index(cell)] : kAir;
}

Tiles tiles_from(std::string_view text, const std::string& name) {
    TilesText tiles(name);
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        tiles.read_line(text.substr(at, end - at));
        at = end + 1;
    }
    return tiles.whole();
}

std::string text_of(const Tiles& tiles) {
    std::string text;
    for (int z = 0; z < tiles.size.z; ++z) {
        if (z > 0) text.push_back('\n');
        for (int y = 0; y < tiles.size.y; ++y)
            text.append(tiles.cells, tiles.index({0, y, z}), static_cast<std::size_t>(tiles.size.x)).push_back('\n');
    }
    return text;
}

Tiles synthesise(const Tiles& example, glm::ivec3 size, const std::vector<Weight>& weights, base::Seed seed,
                 Parts* parts) {
    Parts counted;
    assert(size.x > 0 && size.y > 0 && size.z > 0);
    const Rules rules(example);
    std::vector<float> chances(rules.kinds.size());
    const auto total = static_cast<float>(example.cells.size());
    for (std::size_t k = 0; k < chances.size(); ++k) chances[k] = std::max(rules.share[k] / total, 1.0e-4F);
    for (const Weight& weight : weights) {
        const std::size_t k = rules.number(weight.tile);
        if (k < chances.size()) chances[k] = std::max(chances[k] * weight.times, 1.0e-6F);
    }
    Tiles tiles{size, std::string(static_cast<std::size_t>(size.x) * size.y * size.z, Tiles::kAir)};
    base::RandomStream random{seed};
    // Parts overlap, so that no line shows where one ended.
    constexpr int kPart = 10;
    constexpr int kAttempts = 6;
    constexpr int kPasses = 3;
    for (int pass = 0; pass < kPasses; ++pass) {
        const int shift = pass * kPart / 2;
        for (int z = 0; z < size.z; z += kPart)
            for (int y = -shift % kPart; y < size.y; y += kPart)
                for (int x = -shift % kPart; x < size.x; x += kPart) {
                    const auto within = [&](int v, int most) { return std::clamp(v, 0, most); };
                    const glm::ivec3 from{within(x, size.x), within(y, size.y), z};
                    const glm::ivec3 to{within(x + kPart, size.x), within(y + kPart, size.y),
                                        within(z + kPart, size.z)};
                    if (from.x >= to.x || from.y >= to.y) continue;
                    bool is_made = false;
                    for (int attempt = 0; attempt < kAttempts && !is_made; ++attempt)
                        is_made = Part(rules, tiles, from, to).make(tiles, chances, random);
                    ++(is_made ? counted.made : counted.left);
                }
    }
    if (parts != nullptr) *parts = counted;
    return tiles;
}

int forbidden_neighbours(const Tiles& example, const Tiles& tiles) {
    const Rules rules(example);
    int count = 0;
    for (int z = -1; z <= tiles.size.z; ++z)
        for (int y = -1; y <= tiles.size.y; ++y)
            for (int x = -1; x <= tiles.size.x; ++x)
                for (const std::size_t side : {0U, 2U, 4U}) {
                    const glm::ivec3 here{x, y, z};
                    const std::size_t a = rules.number(tiles.at(here));
                    const std::size_t b = rules.number(tiles.at(here + kSides[side]));
                    const bool is_known = a < rules.kinds.size() && b < rules.kinds.size();
                    count += !is_known || (rules.beside[side][a] >> b & 1U) == 0;
                }
    return count;
}

}  // namespace quadrat::synthesis::noise
