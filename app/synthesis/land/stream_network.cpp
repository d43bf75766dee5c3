// SPDX-License-Identifier: Apache-2.0
// After Kelley, Malin & Nielson, "Terrain simulation using a model of stream erosion", 1988: a single straight river is
// subdivided, tributaries join it where land is not drained yet, and the ground is fitted to the network. Where they
// interpolate scattered heights, our ground is the lower envelope of slopes that rise from every bed, which the search
// for a tributary's mouth uses too: a source drains to the bed that its slope stands on. So a new bed lies below the
// ground and above all that would undercut an older one, and each falls all the way (Prusinkiewicz & Hammel 1993 let
// land and river be divided together to that end).
#include "synthesis/land/stream_network.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace quadrat::synthesis::land {
namespace {

constexpr int kSquares = 64;  // a side
constexpr int kCoarse = 8;

float cross(glm::vec2 a, glm::vec2 b) { return a.x * b.y - a.y * b.x; }

bool do_cross(glm::vec2 a, glm::vec2 b, glm::vec2 c, glm::vec2 d) {
    const float side_a = cross(d - c, a - c);
    const float side_b = cross(d - c, b - c);
    const float side_c = cross(b - a, c - a);
    const float side_d = cross(b - a, d - a);
    return side_a * side_b < 0 && side_c * side_d < 0;
}

}  // namespace

// Where on it a slope that passes over the place stands; toward: 1 rising from it, -1 falling.
float StreamNetwork::Link::stand(glm::vec2 at, float toward, float& beside) const {
    const glm::vec2 d = at - foot;
    const float a = glm::dot(d, along);
    const float aside = std::abs(cross(along, d));
    const float t = std::clamp(a - toward * shift * aside, 0.0F, length);
    beside = std::sqrt((t - a) * (t - a) + aside * aside);
    return t;
}

float StreamNetwork::Link::over(glm::vec2 at, float k) const {
    float off = 0;
    const float t = stand(at, 1, off);
    return bed + rise * t + k * off;
}

float StreamNetwork::Link::under(glm::vec2 at, float k) const {
    float off = 0;
    const float t = stand(at, -1, off);
    return bed + rise * t - k * off;
}

// Whether all of it is farther than that, by its foot and length; some links that are farther are not found so.
bool StreamNetwork::Link::is_beyond(glm::vec2 at, float far) const {
    const glm::vec2 d = at - foot;
    const float reach = far + 1.0001F * length;
    return reach < 0 || glm::dot(d, d) > reach * reach;
}

float StreamNetwork::Link::distance(glm::vec2 at) const {
    const glm::vec2 d = at - foot;
    const float a = glm::dot(d, along);
    const float off = std::clamp(a, 0.0F, length) - a;
    const float aside = cross(along, d);
    return std::sqrt(off * off + aside * aside);
}

struct StreamNetwork::Lowest {
    int node = -1;  // its link's upper end
    float run = 0;  // from the link's foot
    float bed = 0;
    float height = std::numeric_limits<float>::max();  // of the slope that stands there
    glm::vec2 at{0};
    bool is_node = false;  // it is the node itself, no place on the link
};

StreamNetwork::Link StreamNetwork::link_from(glm::vec2 foot, float foot_bed, glm::vec2 head, float head_bed) const {
    Link link{foot, head - foot, glm::length(head - foot), foot_bed};
    link.along /= std::max(link.length, 1.0e-9F);
    link.rise = (head_bed - foot_bed) / std::max(link.length, 1.0e-9F);
    const float k = options_.flank;
    link.shift = link.rise / std::sqrt(std::max(k * k - link.rise * link.rise, 1.0e-6F * k * k));
    return link;
}

void StreamNetwork::link(int node) {
    const Node& up = nodes_[static_cast<std::size_t>(node)];
    const Node& down = nodes_[static_cast<std::size_t>(up.down)];
    links_[static_cast<std::size_t>(node)] = link_from(down.at, down.bed, up.at, up.bed);
}

void StreamNetwork::add_node(const Node& node) {
    nodes_.push_back(node);
    links_.emplace_back();
    if (node.down >= 0) link(static_cast<int>(nodes_.size()) - 1);
}

StreamNetwork::Lowest StreamNetwork::lowest(glm::vec2 at) const {
    Lowest best;
    for (int i = 1; i < static_cast<int>(nodes_.size()); ++i) {
        const Link& link = link_of(i);
        // Most are too far by their length and slope alone.
        if (link.is_beyond(at, (best.height - link.bed) / options_.flank)) continue;
        float off = 0;
        const float t = link.stand(at, 1, off);
        const float height = link.bed + link.rise * t + options_.flank * off;
        if (height < best.height) best = {i, t, link.bed + link.rise * t, height, link.foot + t * link.along, false};
    }
    return best;
}

// A bed lower than this would have its valley cut into another stream.
float StreamNetwork::least_bed(glm::vec2 at) const {
    float least = 0;
    for (int i = 1; i < static_cast<int>(nodes_.size()); ++i) {
        const Link& link = link_of(i);
        const float top = link.bed + link.rise * link.length;
        if (!link.is_beyond(at, (top - least) / options_.flank))
            least = std::max(least, link.under(at, options_.flank));
    }
    return least;
}

// The midpoint of each piece moves aside, again and again.
std::vector<glm::vec2> StreamNetwork::course(glm::vec2 from, glm::vec2 to, int pieces, float swing,
                                             base::RandomStream& random) const {
    std::vector<glm::vec2> points{from, to};
    while (static_cast<int>(points.size()) - 1 < pieces) {
        std::vector<glm::vec2> finer;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const glm::vec2 run = points[i + 1] - points[i];
            finer.push_back(points[i]);
            finer.push_back(points[i] + 0.5F * run + swing * random.between(-1, 1) * glm::vec2{-run.y, run.x});
        }
        finer.push_back(points.back());
        points = std::move(finer);
    }
    return points;
}

bool StreamNetwork::is_clear(std::span<const glm::vec2> course) const {
    for (const glm::vec2 at : course)
        if (at != glm::clamp(at, 0.0F, 1.0F)) return false;
    for (std::size_t i = 0; i + 1 < course.size(); ++i) {
        for (std::size_t n = 1; n < nodes_.size(); ++n) {
            const glm::vec2 up = nodes_[n].at;
            const glm::vec2 down = nodes_[static_cast<std::size_t>(nodes_[n].down)].at;
            if (do_cross(course[i], course[i + 1], up, down)) return false;
        }
    }
    return true;
}

// From the mouth up; empty where the course would have to lie over the ground, or be too steep.
std::vector<float> StreamNetwork::beds(std::span<const glm::vec2> course, float mouth, float fall) const {
    constexpr int kLooks = 5;  // at each piece, besides where it begins
    std::vector<float> beds{mouth};
    std::vector<Link> own;
    for (std::size_t i = 1; i < course.size(); ++i) {
        const float length = glm::length(course[i] - course[i - 1]);
        const float below = beds.back();
        std::array<glm::vec2, kLooks> looks{};
        const auto share = [](std::size_t look) { return static_cast<float>(look + 1) / kLooks; };
        for (std::size_t look = 0; look < kLooks; ++look) looks[look] = glm::mix(course[i - 1], course[i], share(look));
        float bed = below + fall * options_.flank * length;
        // Between its ends, too, it lies over what would undercut another, and under the ground.
        for (std::size_t look = 0; look < kLooks; ++look)
            bed = std::max(bed, below + (least_bed(looks[look]) - below) / share(look));
        if (bed > below + 0.98F * options_.flank * length) return {};
        for (std::size_t look = 0; look < kLooks; ++look) {
            float ground = lowest(looks[look]).height;
            // Where it has turned, its own valley farther down may reach here.
            for (const Link& link : own) ground = std::min(ground, link.over(looks[look], options_.flank));
            if (glm::mix(below, bed, share(look)) > ground) return {};
        }
        own.push_back(link_from(course[i - 1], below, course[i], bed));
        beds.push_back(bed);
    }
    return beds;
}

// A mouth near an end of its link moves there: no link becomes much shorter than its neighbours.
StreamNetwork::Lowest StreamNetwork::moved_to_a_node(Lowest mouth) const {
    const float length = link_of(mouth.node).length;
    if (mouth.run > 0.15F * length && mouth.run < 0.85F * length) return mouth;
    mouth.is_node = true;
    if (mouth.run < 0.5F * length) mouth.node = nodes_[static_cast<std::size_t>(mouth.node)].down;
    mouth.at = nodes_[static_cast<std::size_t>(mouth.node)].at;
    mouth.bed = nodes_[static_cast<std::size_t>(mouth.node)].bed;
    return mouth;
}

int StreamNetwork::split(const Lowest& mouth) {
    if (mouth.is_node) return mouth.node;
    const Node up = nodes_[static_cast<std::size_t>(mouth.node)];
    add_node({mouth.at, mouth.bed, up.down, up.level});
    nodes_[static_cast<std::size_t>(mouth.node)].down = static_cast<int>(nodes_.size()) - 1;
    link(mouth.node);
    return static_cast<int>(nodes_.size()) - 1;
}

void StreamNetwork::add_river(base::RandomStream& random) {
    constexpr int kPieces = 32;
    const glm::vec2 mouth{random.between(0.4F, 0.6F), 1.0F};
    const glm::vec2 spring{random.between(0.3F, 0.7F), 0.04F};
    auto points = course(mouth, spring, kPieces, options_.wander, random);
    for (std::size_t i = 1; i < points.size(); ++i) points[i] = glm::clamp(points[i], 0.02F, 0.99F);
    add_node({mouth, 0, -1, 0});
    for (std::size_t i = 1; i < points.size(); ++i) {
        const float run = glm::length(points[i] - points[i - 1]);
        add_node({points[i], nodes_.back().bed + options_.fall * options_.flank * run, static_cast<int>(i) - 1, 0});
    }
}

bool StreamNetwork::add_tributary(glm::vec2 source, const Lowest& mouth, int level, base::RandomStream& random) {
    const float spacing = options_.spacing * std::exp2(-static_cast<float>(level - 1));
    const float length = glm::length(source - mouth.at);
    const int pieces = std::clamp(static_cast<int>(std::ceil(3 * length / spacing)), 2, 16);
    // Steeper with each level (Horton), as beds are toward their springs.
    const float fall = std::min(options_.fall * std::pow(1.7F, static_cast<float>(level)), 0.8F);
    for (const float swing : {options_.wander, 0.4F * options_.wander, 0.0F}) {
        auto points = course(mouth.at, source, pieces, swing, random);
        // It comes out of its mouth, which lies on a link, and so touches that.
        std::vector<glm::vec2> after = points;
        after.front() += 0.02F * (points[1] - points[0]);
        if (!is_clear(after)) continue;
        const auto heights = beds(points, mouth.bed, fall);
        if (heights.empty()) continue;
        int down = split(mouth);
        for (std::size_t i = 1; i < points.size(); ++i) {
            add_node({points[i], heights[i], down, level});
            down = static_cast<int>(nodes_.size()) - 1;
        }
        return true;
    }
    return false;
}

void StreamNetwork::add_tributaries(int level, base::Seed seed) {
    const float spacing = options_.spacing * std::exp2(-static_cast<float>(level - 1));
    const int cells = std::max(1, static_cast<int>(std::round(1.0F / spacing)));
    std::vector<std::pair<std::uint64_t, glm::vec2>> sources;
    for (int v = 0; v < cells; ++v) {
        for (int u = 0; u < cells; ++u) {
            const std::uint64_t hash = base::hash_of(seed, u, v);
            const glm::vec2 in{0.15F + 0.7F * base::unit_of(hash), 0.15F + 0.7F * base::unit_of(hash << 24U)};
            sources.emplace_back(
                base::hash_of(seed, u, v, 1),
                (glm::vec2{static_cast<float>(u), static_cast<float>(v)} + in) / static_cast<float>(cells));
        }
    }
    std::ranges::sort(sources, {}, [](const auto& source) { return source.first; });
    for (const auto& [hash, at] : sources) {
        const Lowest mouth = lowest(at);
        const float distance = glm::length(at - mouth.at);
        float nearest = distance;
        for (int i = 1; i < static_cast<int>(nodes_.size()); ++i)
            if (!link_of(i).is_beyond(at, nearest)) nearest = std::min(nearest, link_of(i).distance(at));
        if (nearest < 0.45F * spacing) continue;
        base::RandomStream random{base::Seed{hash}};
        add_tributary(at, moved_to_a_node(mouth), level, random);
    }
}

StreamNetwork::StreamNetwork(const StreamOptions& options, base::Seed seed) : options_(options) {
    base::RandomStream random{seed.child("river")};
    add_river(random);
    for (int level = 1; level <= options.levels; ++level)
        add_tributaries(level, seed.child(static_cast<std::uint64_t>(level)));
    sort_into_squares();
    for (int i = 0; i < kSquares * kSquares; ++i) {
        const glm::vec2 middle{static_cast<float>(i % kSquares) + 0.5F, static_cast<float>(i / kSquares) + 0.5F};
        highest_ = std::max(highest_, ground(middle / static_cast<float>(kSquares)).height);
    }
}

// Slopes and distances change by no more than flank and one over a run of one: what is much higher and farther than the
// best in the middle of a square is so all over it.
void StreamNetwork::sort_into_squares() {
    const float k = options_.flank;
    const auto chosen = [&](std::span<const int> among, glm::vec2 middle, float half) {
        std::vector<std::array<float, 2>> found(among.size());
        std::array<float, 2> least{std::numeric_limits<float>::max(), std::numeric_limits<float>::max()};
        for (std::size_t i = 0; i < among.size(); ++i) {
            const Link& link = link_of(among[i]);
            found[i] = {link.over(middle, k), link.distance(middle)};
            for (std::size_t c = 0; c < 2; ++c) least[c] = std::min(least[c], found[i][c]);
        }
        const float reach = 2.01F * std::sqrt(2.0F) * half;
        std::vector<int> kept;
        for (std::size_t i = 0; i < among.size(); ++i)
            if (found[i][0] <= least[0] + k * reach || found[i][1] <= least[1] + reach) kept.push_back(among[i]);
        return kept;
    };
    std::vector<int> all;
    for (int i = 1; i < static_cast<int>(nodes_.size()); ++i) all.push_back(i);
    squares_.resize(static_cast<std::size_t>(kSquares * kSquares));
    constexpr int kWithin = kSquares / kCoarse;
    for (int v = 0; v < kCoarse; ++v) {
        for (int u = 0; u < kCoarse; ++u) {
            const glm::vec2 corner{static_cast<float>(u), static_cast<float>(v)};
            const auto some = chosen(all, (corner + 0.5F) / static_cast<float>(kCoarse), 0.5F / kCoarse);
            for (int i = 0; i < kWithin * kWithin; ++i) {
                const int column = u * kWithin + i % kWithin;
                const int row = v * kWithin + i / kWithin;
                const glm::vec2 middle{(static_cast<float>(column) + 0.5F) / kSquares,
                                       (static_cast<float>(row) + 0.5F) / kSquares};
                squares_[static_cast<std::size_t>(row * kSquares + column)] = chosen(some, middle, 0.5F / kSquares);
            }
        }
    }
}

StreamNetwork::Ground StreamNetwork::ground(glm::vec2 at) const {
    const glm::vec2 in = glm::clamp(at, 0.0F, 1.0F);
    const auto square = [](float x) { return std::min(static_cast<int>(x * kSquares), kSquares - 1); };
    Ground ground{std::numeric_limits<float>::max(), std::numeric_limits<float>::max()};
    for (const int node : squares_[static_cast<std::size_t>(square(in.y) * kSquares + square(in.x))]) {
        const Link& link = link_of(node);
        ground.height = std::min(ground.height, link.over(in, options_.flank));
        ground.to_stream = std::min(ground.to_stream, link.distance(in));
    }
    const float beyond = glm::length(at - in);
    ground.height += options_.flank * beyond;
    ground.to_stream += beyond;
    // Flat beside the stream, and no lower than its bed.
    const float finest = options_.spacing * std::exp2(-static_cast<float>(std::max(options_.levels - 1, 0)));
    const float floor = options_.floor * finest;
    const float d = ground.to_stream;
    ground.height -= options_.flank * d * floor / std::max(d + floor, 1.0e-9F);
    return ground;
}

}  // namespace quadrat::synthesis::land
