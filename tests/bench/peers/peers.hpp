// SPDX-License-Identifier: Apache-2.0
// What is measured, a function for those rows that come of the same work; it may return more than was asked for. Each
// takes seconds to minutes.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "bench/peers/rows.hpp"

namespace quadrat::peers {

struct Options {
    std::vector<std::string> rows;  // that are asked for; empty: all
    int turns = 5;
    bool is_quick = false;          // less of everything: to see that it works
    std::string size = "1280x720";  // pixels of the frames
    bool is_as_exported = false;    // Chromium has what `quadrat export` writes, which has no levels of detail
    std::string folder;             // where the landscapes for Chromium are kept; "": nowhere
};

bool is_asked(const Options& how, std::string_view row);

std::vector<Row> chain(const Options& how);     // chain, chain_cgal
std::vector<Row> fbm(const Options& how);       // fbm, fbm_plain
std::vector<Row> skeleton(const Options& how);  // skeleton
std::vector<Row> passes(const Options& how);    // land_pass, sky_pass
// frame_alpha_1, frame_alpha_02, memory, first_frame, generation. program: this one, which it starts anew for each
// turn.
std::vector<Row> whole(const Options& how, const std::string& program);

// What one of our turns of `whole` prints, a JSON object: of four landscapes grown from nothing and flown over.
std::string four_views(const Options& how);

}  // namespace quadrat::peers
