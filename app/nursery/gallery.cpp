// SPDX-License-Identifier: Apache-2.0
#include "nursery/gallery.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "genome/scene_code.hpp"

namespace quadrat::nursery {

std::optional<genome::Recipe> Gallery::newest() const {
    const auto is_shown = [&](const genome::Recipe& recipe) {
        return chosen_.hidden.empty() ||
               std::ranges::find(chosen_.hidden, genome::code_of(recipe)) == chosen_.hidden.end();
    };
    const auto found = std::ranges::find_if(bred_, is_shown);
    return found == bred_.end() ? std::nullopt : std::optional(*found);
}

void Gallery::plan() {
    wall_.clear();
    std::vector<std::string> codes = chosen_.hidden;  // of what hangs too: nothing hangs twice
    const auto add = [&](const genome::Recipe& recipe) {
        std::string code = genome::code_of(recipe);
        if (wall_.size() >= kMost || std::ranges::find(codes, code) != codes.end()) return;
        codes.push_back(std::move(code));
        wall_.push_back(recipe);
    };
    if (const auto first = newest()) add(*first);
    for (std::size_t i = 0; i < chosen_.favourites.size(); ++i)
        add(chosen_.favourites[(turn_ + i) % chosen_.favourites.size()]);
    std::ranges::for_each(bred_, add);
}

// What hung before need not grow again, as far as the order allows.
void Gallery::hang_what_is_here() {
    plan();
    Scenes scenes;
    std::vector<genome::Recipe> here;
    for (const genome::Recipe& recipe : wall_) {
        const auto found = std::ranges::find(here_, recipe);
        if (found == here_.end()) break;
        scenes.push_back(act_.scenes[static_cast<std::size_t>(found - here_.begin())]);
        here.push_back(recipe);
    }
    act_.scenes = std::move(scenes);
    here_ = std::move(here);
}

void Gallery::hang(const Act& finale) {
    assert(!finale.scenes.empty() && finale.scenes.size() == finale.recipes.size());
    act_.scenes.insert(act_.scenes.begin(), finale.scenes.front());
    here_.insert(here_.begin(), finale.recipes.front());
    bred_.insert(bred_.begin(), finale.recipes.front());
    bred_.resize(std::min(bred_.size(), kRemembered));
    act_.number = finale.number;
    hang_what_is_here();
}

void Gallery::choose(Chosen chosen) {
    if (chosen == chosen_) return;
    chosen_ = std::move(chosen);
    turn_ = 0;
    hang_what_is_here();
}

void Gallery::make_room() {
    const bool is_newest_here = !here_.empty() && newest() == here_.front();
    act_.scenes.resize(is_newest_here ? 1 : 0);
    here_.resize(act_.scenes.size());
    if (!chosen_.favourites.empty()) turn_ = (turn_ + kMost - 1) % chosen_.favourites.size();
    plan();
}

std::optional<genome::Recipe> Gallery::missing() const {
    if (here_.size() >= wall_.size()) return std::nullopt;
    return wall_[here_.size()];
}

void Gallery::bring_back(const genome::Recipe& recipe, std::shared_ptr<const scene::Scene> scene) {
    if (missing() != recipe) return;
    act_.scenes.push_back(std::move(scene));
    here_.push_back(recipe);
}

void Gallery::replace(const std::shared_ptr<const scene::Scene>& old, const std::shared_ptr<const scene::Scene>& by) {
    std::ranges::replace(act_.scenes, old, by);
}

}  // namespace quadrat::nursery
