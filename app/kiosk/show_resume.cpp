// SPDX-License-Identifier: Apache-2.0
// A visit that a pulled plug interrupted, taken up: its deeds lead to the same four again, or it is left alone.
#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "base/log.hpp"
#include "kiosk/show.hpp"

namespace quadrat::kiosk {

using exhibit::Screen;

bool Show::take_up(base::Instant now) {
    if (has_asked_keeper_) return false;
    const auto kept = keeper_->kept();
    if (!kept) return false;
    has_asked_keeper_ = true;
    const bool is_free = state_.screen == exhibit::Screen::Attract && visits_ended_ == 0;
    if (!kept->interrupted || !is_free) return false;
    const std::optional<breeding::Session> prepared = session_;
    if (resume(*kept->interrupted, now)) {
        spoken_.resume(kept->language);
        return true;
    }
    session_ = prepared;
    return false;
}

// What is wrong; "" when the session is the one that was interrupted.
std::string Show::why_not_resumed(const archive::Generation& kept, const breeding::WordMap& map,
                                  const breeding::Taste& taste) {
    session_.reset();
    try {
        breeding::BreederOptions options = options_of_visit(breeder_options_, control_every_, kept.seed);
        options.map = map;
        options.taste = taste;
        breeding::Breeder breeder(options);
        if (breeder.name() != kept.breeder)
            return fmt::format("the breeder is {} now, and was {}", breeder.name(), kept.breeder);
        for (const genome::Aspect aspect : locked_) breeder.set_lock(aspect, breeding::Lock::Locked);
        session_.emplace(std::move(breeder), kept.seed);
        for (const archive::Deed& deed : kept.deeds) {
            if (deed.step && static_cast<std::size_t>(deed.step->slider) >= session_->breeder().sliders())
                throw base::InputError(fmt::format("there is no slider {}", deed.step->slider));
            if (deed.step)
                session_->slide(static_cast<std::size_t>(deed.step->slider), deed.step->direction);
            else
                session_->next(deed.pick);
        }
    } catch (const base::InputError& error) {
        session_.reset();
        return error.what();
    }
    if (archive::digest_of(session_->offer()) == kept.digest) return "";
    session_.reset();
    return "the breeding is tuned differently now, so the four would not be the same";
}

bool Show::resume(const archive::Generation& kept, base::Instant now) {
    std::string why_not = why_not_resumed(kept, school_->map(), school_->taste());
    // The visit may have begun before the last lesson, which changed one of them or both.
    if (!why_not.empty()) {
        const auto resumes = [&](const breeding::WordMap& map, const breeding::Taste& taste) {
            return why_not_resumed(kept, map, taste).empty();
        };
        const breeding::Taste taste_before = school_->taste_before();
        bool is_resumed = resumes(school_->map(), taste_before);
        // It is made anew from what was taught: only where nothing else helps.
        if (const auto map_before = is_resumed ? std::nullopt : school_->map_before())
            is_resumed = resumes(*map_before, school_->taste()) || resumes(*map_before, taste_before);
        if (is_resumed) why_not.clear();
    }
    if (!why_not.empty()) {
        base::log::warn("the interrupted visit is not taken up: {}", why_not);
        return false;
    }
    *visit_ = kept.visit;
    base::log::info("taking up visit {} at round {}, which was interrupted", kept.visit, kept.round);
    deeds_ = kept.deeds;
    std::vector<genome::Pick> picks;
    for (const archive::Deed& deed : kept.deeds) picks.push_back(deed.pick);
    step({is_sliding() ? exhibit::resumed_sliding(kept.round - 1, now)
                       : exhibit::resumed(std::move(picks), kept.answers, now),
          {}},
         now);
    grow_offer(state_.generation, 0);
    return true;
}

}  // namespace quadrat::kiosk
