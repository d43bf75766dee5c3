// SPDX-License-Identifier: Apache-2.0
#include "nursery/gallery.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/log.hpp"
#include "genome/scene_code.hpp"
#include "genome/season.hpp"

namespace quadrat::nursery {

bool Gallery::is_hidden(const genome::Recipe& recipe) const {
    return !chosen_.hidden.empty() &&
           std::ranges::find(chosen_.hidden, genome::code_of(recipe)) != chosen_.hidden.end();
}

// Of those before it, where it is hidden or none was bred in this run.
const Work* Gallery::newest() const {
    if (newest_ && !is_hidden(newest_->recipe)) return &*newest_;
    const auto found =
        std::ranges::find_if(collection_.works(), [&](const Work& work) { return !is_hidden(work.recipe); });
    return found == collection_.works().end() ? nullptr : &*found;
}

void Gallery::plan() {
    wall_.clear();
    std::vector<Work> hung;
    const auto add = [&](const Work& work) {
        const bool is_seen = std::ranges::any_of(hung, [&](const Work& other) { return are_alike(other, work); });
        if (wall_.size() >= kMost || is_seen || std::ranges::find(chosen_.hidden, work.code) != chosen_.hidden.end())
            return;
        hung.push_back(work);
        wall_.push_back(work.recipe);
    };
    const auto add_recipe = [&](const genome::Recipe& recipe) {
        Work unknown;
        unknown.code = genome::code_of(recipe);
        unknown.recipe = recipe;
        const Work* known = collection_.find(unknown.code);
        add(known == nullptr ? unknown : *known);
    };
    if (const Work* first = newest()) add(*first);
    for (std::size_t i = 0; i < chosen_.favourites.size(); ++i)
        add_recipe(chosen_.favourites[(turn_ + i) % chosen_.favourites.size()]);
    std::ranges::for_each(collection_.ranked(), add_recipe);
    if (chosen_.shows_year && !wall_.empty())
        for (genome::Recipe& season : genome::rest_of_year(wall_.front())) wall_.push_back(std::move(season));
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

void Gallery::hang(const Act& finale, const Birth& birth) {
    assert(!finale.scenes.empty() && finale.scenes.size() == finale.recipes.size());
    act_.scenes.insert(act_.scenes.begin(), finale.scenes.front());
    here_.insert(here_.begin(), finale.recipes.front());
    Work work;
    work.recipe = finale.recipes.front();
    work.code = genome::code_of(work.recipe);
    work.words = birth.words;
    work.day = birth.day;
    work.parent = birth.parent;
    if (const Work* parent = collection_.find(birth.parent)) work.generation = parent->generation + 1;
    newest_ = work;
    collection_.admit(std::move(work));
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
    const bool is_newest_here = !here_.empty() && newest() != nullptr && newest()->recipe == here_.front();
    act_.scenes.resize(is_newest_here ? 1 : 0);
    here_.resize(act_.scenes.size());
    if (!chosen_.favourites.empty()) turn_ = (turn_ + kMost - 1) % chosen_.favourites.size();
    plan();
}

void Gallery::recall(Collection collection) {
    // What has been bred meanwhile is newer.
    const std::vector<Work> meanwhile = collection_.works();
    collection_ = std::move(collection);
    for (auto work = meanwhile.rbegin(); work != meanwhile.rend(); ++work) collection_.admit(*work);
    hang_what_is_here();
}

void Gallery::open(base::Instant now) { act_.arrived = now; }

std::optional<std::size_t> Gallery::shown(base::Instant now) const {
    if (here_.empty()) return std::nullopt;
    const auto turns = static_cast<std::size_t>(std::max(now - act_.arrived, base::Instant{0}) / kShownFor);
    return turns % here_.size();
}

std::string Gallery::code_shown(base::Instant now) const {
    const auto index = shown(now);
    return index ? genome::code_of(here_[*index]) : "";
}

void Gallery::leave(base::Instant now, Came who) {
    if (who == Came::ToBreedOn) base::log::info("a landscape that hung here is bred on from");
    const auto last = shown(now);
    const base::Instant open_for = std::max(now - act_.arrived, base::Instant{0});
    for (std::size_t i = 0; i < here_.size(); ++i) {
        // Whole rounds, and what there was of the last one.
        const auto count = static_cast<std::int64_t>(here_.size());
        const base::Instant round = kShownFor * count;
        const base::Instant in_last = open_for % round - kShownFor * static_cast<std::int64_t>(i);
        const base::Instant shown_for = open_for / round * kShownFor + std::clamp(in_last, base::Instant{0}, kShownFor);
        const std::string code = genome::code_of(here_[i]);
        collection_.was_shown(code, std::chrono::duration<double>(shown_for).count());
        if (last == i && who != Came::Nobody) collection_.was_stopped_at(code, who == Came::ToBreedOn);
    }
    act_.arrived = now;
}

void Gallery::turn() {
    if (!chosen_.favourites.empty()) turn_ = (turn_ + 1) % chosen_.favourites.size();
    hang_what_is_here();
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
