// SPDX-License-Identifier: Apache-2.0
#include "kiosk/programme.hpp"

#include <utility>

namespace quadrat::kiosk {

Programme::Programme(const nursery::NurseryOptions& options, const nursery::Wall::Read& works) : nursery_(options) {
    if (works) wall_.emplace(works);
}

// What is asked of the nursery: what somebody waits for, then better light for what is shown, then the gallery's.
void Programme::want() {
    using nursery::Stage;
    using nursery::Urgency;
    std::vector<nursery::Want> wants;
    if (coming_) {
        wants = nursery::wants_for(coming_->landscapes, Stage::FirstLight, Urgency::Awaited);
    } else if (!is_full_) {
        wants = nursery::wants_for(newest_, Stage::FullLight, Urgency::Shown);
    } else if (const auto next = spare()) {
        wants = nursery::wants_for({next}, Stage::FullLight, Urgency::Spare);
    }
    nursery_.want(std::move(wants));
}

void Programme::order(Coming coming, const std::vector<genome::Candidate>& candidates, base::Seed flight) {
    regrowing_.reset();
    refined_.reset();
    coming_ = std::move(coming);
    coming_->landscapes = nursery::landscapes_of(candidates, flight);
    want();
    look();
}

bool Programme::has_progressed() {
    const float now = progress();
    return std::exchange(told_progress_, now) != now;
}

void Programme::wait() {
    if (spare() || (coming_ && !coming_->act)) nursery_.wait();
    look();
}

void Programme::look() {
    if (coming_) {
        if (coming_->act) return;
        auto grown = nursery_.find(coming_->landscapes);
        if (!grown) return;
        coming_->act = nursery::Act{std::move(grown->scenes), {}, ++acts_, {}};
        for (const auto& landscape : coming_->landscapes)
            coming_->act->recipes.push_back(genome::recipe_of(landscape->candidate, landscape->flight));
        coming_->is_full = grown->is_full;
    } else if (!refined_ && (!is_full_ || spare())) {
        auto grown = nursery_.find(is_full_ ? nursery::Landscapes{spare()} : newest_);
        if (grown && grown->is_full) refined_ = nursery::Act{std::move(grown->scenes), {}, acts_, {}};
    }
}

Coming Programme::uploaded(base::Instant arrived, const nursery::Birth& birth) {
    Coming done = std::move(*coming_);
    coming_.reset();
    done.act->arrived = arrived;
    newest_ = done.landscapes;
    is_full_ = done.is_full;
    if (done.is_finale) {
        finale_ = *done.act;
        gallery_.hang(finale_, birth);
    } else {
        offered_ = *done.act;
    }
    want();
    return done;
}

void Programme::note_refined() {
    if (!refined_) return;
    if (!is_full_) {
        for (nursery::Act* act : {&offered_, &finale_}) {
            if (act->number != refined_->number) continue;
            for (std::size_t i = 0; i < act->scenes.size(); ++i) gallery_.replace(act->scenes[i], refined_->scenes[i]);
            act->scenes = refined_->scenes;
        }
        is_full_ = true;
    } else if (asked_about_.is_growing()) {
        nursery::Act& act = asked_about_.act.emplace(std::move(*refined_));
        act.number = ++acts_;
        act.recipes = {genome::recipe_of(asked_about_.landscape->candidate, asked_about_.landscape->flight)};
    } else {
        const auto grown = std::exchange(regrowing_, nullptr);
        gallery_.bring_back(genome::recipe_of(grown->candidate, grown->flight), refined_->scenes.front());
    }
    refined_.reset();
    want();
}

void Programme::ask_about(std::shared_ptr<const nursery::Landscape> other) {
    if (asked_about_.is_growing()) refined_.reset();  // it may be of that
    asked_about_ = {.landscape = std::move(other)};
    want();
}

const nursery::Landscape* Programme::begin_asking(base::Instant now) {
    if (!asked_about_.act) {
        ask_about(nullptr);  // it would come in the midst of a question
        return nullptr;
    }
    asked_about_.is_shown = true;
    asked_about_.act->arrived = now;
    return asked_about_.landscape.get();
}

void Programme::begin_visit(base::Instant now) {
    stop_regrowing();
    gallery_.make_room();
    offered_.arrived = now;
}

void Programme::choose(nursery::Chosen chosen) {
    if (!wall_) gallery_.choose(std::move(chosen));
}

void Programme::open_gallery(base::Instant now) {
    ask_about(nullptr);
    gallery_.open(now);
}

void Programme::leave_gallery(bool breeds_on, base::Instant now) {
    using Came = nursery::Gallery::Came;
    liked_ = breeds_on ? gallery_.code_shown(now) : "";
    gallery_.leave(now, liked_.empty() ? Came::Somebody : Came::ToBreedOn);
}

void Programme::look_at_wall(base::Instant now) {
    if (wall_) wall_->look(gallery_, now);
}

void Programme::regrow_gallery() {
    if (coming_ || offered_.scenes.empty() || regrowing_ || !has_nothing_to_refine()) return;
    const auto recipe = gallery_.missing();
    if (!recipe) return;
    regrowing_ = nursery::landscape_of(genome::candidate_of(*recipe), recipe->flight);
    want();
}

// What grows of it is not asked for any more.
void Programme::stop_regrowing() {
    if (!std::exchange(regrowing_, nullptr)) return;
    refined_.reset();
    want();
}

const nursery::Act& Programme::act_of(exhibit::Screen screen) const {
    using exhibit::Screen;
    if (screen == Screen::Describe && asked_about_.is_shown) return *asked_about_.act;
    if (screen == Screen::Finale || screen == Screen::Describe || screen == Screen::Family) return finale_;
    if (screen == Screen::Attract && !gallery_.act().scenes.empty()) return gallery_.act();
    return offered_;
}

std::span<const genome::Recipe> Programme::recipes_of(exhibit::Screen screen) const {
    const nursery::Act& act = act_of(screen);
    return &act == &gallery_.act() ? gallery_.recipes() : std::span(act.recipes);
}

nursery::Scenes Programme::in_use() const {
    nursery::Scenes all;
    for (const nursery::Act* act : {&offered_, &finale_, &gallery_.act()})
        all.insert(all.end(), act->scenes.begin(), act->scenes.end());
    if (const auto& asked = asked_about_.act) all.insert(all.end(), asked->scenes.begin(), asked->scenes.end());
    return all;
}

}  // namespace quadrat::kiosk
