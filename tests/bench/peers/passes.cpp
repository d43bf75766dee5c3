// SPDX-License-Identifier: Apache-2.0
#include "benches/passes.hpp"

#include "bench/peers/peers.hpp"
#include "benches/four_views.hpp"

namespace quadrat::peers {

std::vector<Row> passes(const Options& how) {
    benches::Options frames;
    frames.size = how.size;
    benches::FourViews views(frames);
    const auto row_of = [](const char* name, const char* against, double goal, const benches::PassTurns& turns) {
        return Row{name, "ms", against, goal, {turns.ours_ms, turns.plain_ms}};
    };
    return {row_of("land_pass", "a plain ground of 512 triangles, lit, without a picture of its light", 1.5,
                   benches::land_pass(views.easel, views.picture, 16, how.turns)),
            row_of("sky_pass", "a sky without clouds by Preetham's formula a pixel", 0.85,
                   benches::sky_pass(views.easel, views.picture, how.turns))};
}

}  // namespace quadrat::peers
