// SPDX-License-Identifier: Apache-2.0
#include "benches/passes.hpp"

#include <fmt/format.h>

#include "bench/peers/peers.hpp"
#include "benches/four_views.hpp"

namespace quadrat::peers {

std::vector<Row> passes(const Options& how) {
    benches::Options frames;
    frames.size = how.size;
    benches::FourViews views(frames);
    Row land{"land_pass", "ms", "a plain ground of 512 triangles, lit, without a picture of its light", 1.5};
    if (is_asked(how, land.name)) {
        benches::PassTurns turns = benches::land_pass(views.easel, views.picture, 16, how.turns);
        land.note = fmt::format("with its grass and stones {} triangles", turns.triangles);
        land.turns = {std::move(turns.ours_ms), std::move(turns.plain_ms)};
    }
    Row sky{"sky_pass", "ms", "a sky without clouds by Preetham's formula a pixel", 0.85};
    if (is_asked(how, sky.name)) {
        benches::PassTurns turns = benches::sky_pass(views.easel, views.picture, how.turns);
        sky.turns = {std::move(turns.ours_ms), std::move(turns.plain_ms)};
    }
    return {land, sky};
}

}  // namespace quadrat::peers
