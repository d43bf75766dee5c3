// SPDX-License-Identifier: Apache-2.0
// What grows when nobody waits: landscapes that are shown already, in their own light, and those of the gallery.
#include <utility>

#include "kiosk/show.hpp"

namespace quadrat::kiosk {

using exhibit::Screen;

// What a visit had no room for, when the four of the next stand and nobody has come.
void Show::regrow_gallery() {
    if (state_.screen != exhibit::Screen::Attract || waiting_ || offered_.scenes.empty() || is_regrowing_ ||
        !is_refined())
        return;
    const auto recipe = gallery_.missing();
    if (!recipe) return;
    is_regrowing_ = true;
    regrowing_ = *recipe;
    grower_.order({{genome::candidate_of(*recipe)}, recipe->flight});
}

// What grows of it is not asked for any more.
void Show::stop_regrowing() {
    if (std::exchange(is_regrowing_, false)) refined_.reset();
}

const nursery::Act* Show::waiting_to_refine() {
    if (!waiting_ && !refined_) {
        grower_.refine();
        std::optional<nursery::Scenes> scenes;
        if (!is_regrowing_)
            scenes = grower_.take_refined();
        else if (is_refined())  // nobody waits for what comes back to the gallery
            scenes = grower_.take();
        if (scenes) refined_ = nursery::Act{std::move(*scenes), {}, acts_, {}};
    }
    return refined_ ? &*refined_ : nullptr;
}

void Show::refined() {
    if (!refined_) return;
    if (std::exchange(is_regrowing_, false)) {
        gallery_.bring_back(regrowing_, refined_->scenes.front());
        refined_.reset();
        return;
    }
    for (nursery::Act* act : {&offered_, &finale_}) {
        if (act->number != refined_->number) continue;
        for (std::size_t i = 0; i < act->scenes.size(); ++i) gallery_.replace(act->scenes[i], refined_->scenes[i]);
        act->scenes = refined_->scenes;
    }
    refined_.reset();
}

}  // namespace quadrat::kiosk
