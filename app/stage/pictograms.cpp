// SPDX-License-Identifier: Apache-2.0
#include "stage/pictograms.hpp"

#include <algorithm>
#include <array>

namespace quadrat::stage {
namespace {

using enum render::Pictogram;

constexpr std::size_t kMost = 3;
struct Row {
    std::string_view key;
    std::array<render::Pictogram, kMost> pictograms;
    std::size_t count;
};

// A press that lasts is a press and a clock.
constexpr std::array kRows{
    Row{"attract", {Press}, 1},
    Row{"ask.language", {Language}, 1},
    Row{"ask.trees", {Tree}, 1},
    Row{"ask.land", {Land}, 1},
    Row{"ask.sky", {Sky}, 1},
    Row{"breed", {Sprout}, 1},
    Row{"still-there", {Clock, Press}, 2},
    Row{"finale", {Frame}, 1},
    Row{"first", {Sprout}, 1},
    Row{"describe.trees", {Speech, Tree}, 2},
    Row{"describe.land", {Speech, Land}, 2},
    Row{"describe.sky", {Speech, Sky}, 2},
    Row{"slide", {Slider}, 1},
    Row{"back", {Back}, 1},
    Row{"invite.one", {Press, Clock}, 2},
    Row{"invite.two", {Press, Press, Clock}, 3},
    Row{"hold.one", {Press, Clock}, 2},
    Row{"hold.two", {Press, Press, Clock}, 3},
    Row{"scan.one", {Mark, Press}, 2},
    Row{"scan.step", {Press, Mark, Clock}, 3},
    Row{"scan.two", {Press, Mark, Press}, 3},
    Row{"scan.rest", {Press}, 1},
    Row{"hear.again", {Back, Clock, Sound}, 3},
    Row{"take-home", {House}, 1},
    Row{"closed", {Moon}, 1},
    Row{"turns", {Person}, 1},
    Row{"family", {Family}, 1},
    Row{"go-on", {Sprout}, 1},
    Row{"print", {Print}, 1},
    Row{"printing", {Print, Clock}, 2},
    Row{"done", {Done}, 1},
    Row{"breed-on", {Sprout}, 1},
};

}  // namespace

std::span<const render::Pictogram> pictograms_for(std::string_view key) {
    const auto* row = std::ranges::find(kRows, key, &Row::key);
    if (row == kRows.end()) return {};
    return {row->pictograms.data(), row->count};
}

}  // namespace quadrat::stage
