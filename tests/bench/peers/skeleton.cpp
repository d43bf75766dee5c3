// SPDX-License-Identifier: Apache-2.0
// The straight skeletons of two outlines: a star of many points and the walls of a maze.
#include <fmt/format.h>

#include "bench/peers/cgal.hpp"
#include "bench/peers/peers.hpp"
#include "support/plans.hpp"

namespace quadrat::peers {
namespace {

std::vector<mesh::Plan> outlines(int corners) {
    base::RandomStream of_star{base::Seed{3}};
    base::RandomStream of_maze{base::Seed{4}};
    const int side = static_cast<int>(std::sqrt(corners / 1.7));
    return {{tests::star_loop(corners, 10 - 2 * std::min(1.0, 300.0 / corners), 10, {0, 0}, of_star), {}},
            {tests::maze_loop(side, 0.1, of_maze), {}}};
}

}  // namespace

std::vector<Row> skeleton(const Options& how) {
    const int corners = how.is_quick ? 60 : 1000;
    const std::vector<mesh::Plan> plans = outlines(corners);
    const auto each = [&](const auto& work) {
        return own_ms([&] {
            for (const mesh::Plan& plan : plans) work(plan);
        });
    };
    const auto ours = [&] { return each([](const mesh::Plan& plan) { mesh::straight_skeleton(plan); }); };
    const auto cgal = [&] { return each([](const mesh::Plan& plan) { skeleton_by_cgal(plan); }); };
    Row row{"skeleton", "ms", fmt::format("CGAL, a star and a maze of some {} corners", corners), 0.1};
    row.why = why_no_cgal();
    row.turns = in_turns(how.turns, ours, row.why.empty() ? std::function<double()>(cgal) : nullptr);
    return {row};
}

}  // namespace quadrat::peers
