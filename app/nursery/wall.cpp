// SPDX-License-Identifier: Apache-2.0
#include "nursery/wall.hpp"

#include <algorithm>

#include "genome/scene_code.hpp"

namespace quadrat::nursery {

void Wall::look(Gallery& gallery, base::Instant now) {
    if (!reading_.is_something() && (!read_at_ || now - *read_at_ >= kReadEvery)) {
        read_at_ = now;
        reading_ = reader_.begin(read_);
    }
    if (reading_.is_something() && reading_.is_over()) {
        works_ = reading_.get();
        Chosen chosen;
        for (const Work& work : works_) chosen.favourites.push_back(work.recipe);
        gallery.choose(std::move(chosen));
    }
    // The first that hangs is shown; then it goes, and the next one is the first.
    if (!opened_at_ && gallery.shown(now)) {
        opened_at_ = now;
        gallery.open(now);
    }
    if (opened_at_ && now - *opened_at_ >= Gallery::kShownFor && gallery.recipes().size() > 1) {
        gallery.turn();
        gallery.open(now);
        opened_at_ = now;
    }
    const auto shown = gallery.shown(now);
    shown_ = shown ? std::optional(gallery.recipes()[*shown]) : std::nullopt;
}

std::string Wall::caption(const genome::Language& language) const {
    const auto work = std::ranges::find_if(works_, [&](const Work& one) { return shown_ == one.recipe; });
    return work == works_.end() || !work->words ? "" : language.describe(*work->words);
}

std::string Wall::address(const std::string& url) const {
    return url.empty() || !shown_ ? "" : url + genome::code_of(*shown_);
}

}  // namespace quadrat::nursery
