// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "base/seed.hpp"
#include "mesh/straight_skeleton.hpp"

// Polygons to roof: by chance, and such as builders draw.
namespace quadrat::tests {

using Loop = std::vector<glm::dvec2>;

// Whatever a fuzzer says: four bytes a point, in so many metres; a point far to the left begins a hole.
inline mesh::Plan plan_of_bytes(const std::uint8_t* data, std::size_t size, double unit_m) {
    mesh::Plan plan;
    Loop* loop = &plan.outer;
    for (std::size_t i = 0; i + 4 <= size; i += 4) {
        std::int16_t x = 0;
        std::int16_t y = 0;
        std::memcpy(&x, data + i, 2);
        std::memcpy(&y, data + i + 2, 2);
        if (x == -32768)
            loop = &plan.holes.emplace_back();
        else
            loop->emplace_back(x * unit_m, y * unit_m);
    }
    return plan;
}

inline double signed_area(const Loop& loop) {
    double area = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec2 a = loop[i];
        const glm::dvec2 b = loop[(i + 1) % loop.size()];
        area += a.x * b.y - b.x * a.y;
    }
    return 0.5 * area;
}

inline double area_of(const mesh::Plan& plan) {
    double area = std::abs(signed_area(plan.outer));
    for (const Loop& hole : plan.holes) area -= std::abs(signed_area(hole));
    return area;
}

// Round a centre at uneven distances.
inline Loop star_loop(int corners, double least, double most, glm::dvec2 at, base::RandomStream& chance) {
    Loop loop;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.8 * chance.unit()) / corners;
        const double reach = least + (most - least) * chance.unit();
        loop.push_back(at + reach * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return loop;
}

// Round the corridors of a maze that has one way between any two cells; a shaking of 0.1 leaves them apart.
inline Loop maze_loop(int side, double shaking, base::RandomStream& chance) {
    const auto count = static_cast<std::size_t>(side * side);
    std::vector<std::array<bool, 4>> open(count, {false, false, false, false});
    std::vector<std::size_t> root(count);
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find = [&root](std::size_t i) {
        while (root[i] != i) i = root[i];
        return i;
    };
    std::vector<std::pair<std::size_t, int>> walls;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            if (x + 1 < side) walls.emplace_back(y * side + x, 0);
            if (y + 1 < side) walls.emplace_back(y * side + x, 1);
        }
    for (std::size_t i = walls.size(); i > 1; --i)
        std::swap(walls[i - 1], walls[chance.below(static_cast<std::uint32_t>(i))]);
    for (const auto& [cell, way] : walls) {
        const std::size_t other = cell + (way == 0 ? 1 : static_cast<std::size_t>(side));
        if (find(cell) == find(other)) continue;
        root[find(cell)] = find(other);
        open[cell][static_cast<std::size_t>(way)] = true;
        open[other][static_cast<std::size_t>(way) + 2] = true;
    }
    constexpr std::array<std::array<int, 2>, 4> kStep{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    constexpr std::array<std::array<double, 2>, 4> kCorner{{{.8, .2}, {.8, .8}, {.2, .8}, {.2, .2}}};
    Loop loop;
    int x = 0;
    int y = 0;
    std::size_t way = 0;
    const auto corner = [&](std::size_t k) {
        loop.emplace_back(x + kCorner[k][0] + shaking * (chance.unit() - 0.5),
                          y + kCorner[k][1] + shaking * (chance.unit() - 0.5));
    };
    const auto go = [&](std::size_t to) {
        x += kStep[to][0];
        y += kStep[to][1];
        way = to;
    };
    do {
        const std::array<bool, 4>& here = open[static_cast<std::size_t>(y * side + x)];
        const std::size_t right = (way + 3) % 4;
        if (here[right]) {
            corner(right);
            go(right);
        } else if (here[way]) {
            go(way);
        } else {
            corner(way);
            way = (way + 1) % 4;
        }
    } while (x != 0 || y != 0 || way != 0);
    return loop;
}

struct NamedPlan {
    std::string name;
    mesh::Plan plan;
};

inline mesh::Plan turned(const mesh::Plan& plan, double by_rad) {
    const auto turn = [by_rad](glm::dvec2 p) {
        return glm::dvec2(std::cos(by_rad) * p.x - std::sin(by_rad) * p.y,
                          std::sin(by_rad) * p.x + std::cos(by_rad) * p.y);
    };
    mesh::Plan result = plan;
    for (glm::dvec2& p : result.outer) p = turn(p);
    for (Loop& hole : result.holes)
        for (glm::dvec2& p : hole) p = turn(p);
    return result;
}

inline Loop rectangle(double x, double y, double width, double height) {
    return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

inline mesh::Plan comb(int teeth, double tooth, double gap, double depth) {
    mesh::Plan plan;
    const double width = teeth * tooth + (teeth - 1) * gap;
    plan.outer = {{0, 0}, {width, 0}};
    for (int i = teeth - 1; i >= 0; --i) {
        const double left = i * (tooth + gap);
        plan.outer.emplace_back(left + tooth, 1 + depth);
        plan.outer.emplace_back(left, 1 + depth);
        if (i == 0) break;
        plan.outer.emplace_back(left, 1);
        plan.outer.emplace_back(left - gap, 1);
    }
    return plan;
}

// Rectilinear and regular plans, where many edges meet in one point or lie in one line.
inline std::vector<NamedPlan> degenerate_plans() {
    std::vector<NamedPlan> plans;
    const auto add = [&plans](std::string name, mesh::Plan plan) {
        plans.push_back({std::move(name), std::move(plan)});
    };
    for (const double a : {1.0, 2.0, 3.0}) {
        const std::string n = std::to_string(static_cast<int>(a));
        add("rectangle" + n, {rectangle(0, 0, 4, a), {}});
        add("L" + n, {{{0, 0}, {6, 0}, {6, a}, {a, a}, {a, 6}, {0, 6}}, {}});
        add("T" + n, {{{-4, 0}, {-1, 0}, {-1, -5}, {1, -5}, {1, 0}, {4, 0}, {4, a}, {-4, a}}, {}});
        add("U" + n, {{{0, 0}, {8, 0}, {8, 6}, {8 - a, 6}, {8 - a, 2}, {a, 2}, {a, 6}, {0, 6}}, {}});
        add("H" + n, {{{0, 0},
                       {a, 0},
                       {a, 3},
                       {8 - a, 3},
                       {8 - a, 0},
                       {8, 0},
                       {8, 8},
                       {8 - a, 8},
                       {8 - a, 5},
                       {a, 5},
                       {a, 8},
                       {0, 8}},
                      {}});
        add("cross" + n, {{{-1, -a - 1},
                           {1, -a - 1},
                           {1, -1},
                           {4, -1},
                           {4, 1},
                           {1, 1},
                           {1, a + 1},
                           {-1, a + 1},
                           {-1, 1},
                           {-4, 1},
                           {-4, -1},
                           {-1, -1}},
                          {}});
        add("Z" + n, {{{0, 0}, {5, 0}, {5, 2}, {1.5 + a, 2}, {1.5 + a, 6}, {-1, 6}, {-1, 4}, {0, 4}}, {}});
        add("court" + n, {rectangle(0, 0, 9, 9), {rectangle(a, a, 9 - 2 * a, 9 - 2 * a)}});
        add("side court" + n, {rectangle(0, 0, 12, 8), {rectangle(a, a, 4, 3)}});
        add("two courts" + n, {rectangle(0, 0, 13, 7), {rectangle(a, 2, 2, 3), rectangle(9 - a + 1, 2, 2, 3)}});
        add("comb" + n, comb(3 + static_cast<int>(a), 1, a, 2));
        add("deep comb" + n, comb(4, a, 1, 5));
    }
    for (int n = 3; n <= 16; ++n) {
        mesh::Plan regular;
        mesh::Plan star;
        for (int i = 0; i < 2 * n; ++i) {
            const double angle = std::numbers::pi * i / n;
            const glm::dvec2 way(std::cos(angle), std::sin(angle));
            if (i % 2 == 0) regular.outer.push_back(10.0 * way);
            star.outer.push_back((i % 2 == 0 ? 10.0 : 4.5) * way);
        }
        add("regular" + std::to_string(n), regular);
        add("star" + std::to_string(n), star);
        mesh::Plan ring = regular;
        ring.holes = {regular.outer};
        for (glm::dvec2& p : ring.holes[0]) p *= 0.4;
        add("ring" + std::to_string(n), ring);
    }
    const std::size_t straight = plans.size();
    for (std::size_t i = 0; i < straight; ++i)
        add(plans[i].name + " turned", turned(plans[i].plan, 0.37 + 0.01 * static_cast<double>(i)));
    for (std::size_t i = 0; i < 36; ++i)
        add(plans[i].name + " by a third", turned(plans[i].plan, std::numbers::pi / 6));
    for (std::size_t i = 0; i < 10; ++i) add(plans[i].name + " half over", turned(plans[i].plan, std::numbers::pi / 4));
    return plans;
}

// What must hold of every roof: empty where it does, otherwise what does not.
std::string fault_of(const mesh::Plan& plan, const mesh::RoofOptions& options, const mesh::Roof& roof);

}  // namespace quadrat::tests
