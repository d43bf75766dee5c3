// SPDX-License-Identifier: Apache-2.0
#include "breeding/session.hpp"

#include <utility>

namespace quadrat::breeding {

genome::Candidate chosen(const genome::Offer& offer, const genome::Pick& pick, const genome::Candidate& otherwise) {
    genome::Candidate mixed = otherwise;
    for (const genome::Aspect aspect : genome::kAspects) {
        if (!pick[aspect]) continue;
        const genome::Candidate& named = offer.candidates.at(*pick[aspect]);
        mixed.bits[aspect] = named.bits[aspect];
        mixed.seeds[aspect] = named.seeds[aspect];
        if (named.words) {
            if (!mixed.words) mixed.words.emplace();
            for (const genome::Word& word : genome::vocabulary(aspect))
                mixed.words->set(word.id, (*named.words)[word.id]);
        }
        for (const genome::ParameterId id : parameters_of(aspect, genome::Genome::Full))
            mixed.values.set(id, named.values[id]);
    }
    return mixed;
}

Session::Session(Breeder breeder, base::Seed seed) : seed_(seed), now_{std::move(breeder), {}, {}} {
    now_.offer = now_.breeder.propose(seed_);
    now_.favourite = now_.offer.candidates.front();
}

base::Seed Session::flight(const genome::Offer& offer) const {
    const int round = now_.breeder.sliders() > 0 ? 1 : offer.round;
    return seed_.child("flight").child(static_cast<std::uint64_t>(round));
}

void Session::go_on_with(Breeder breeder, const genome::Pick& pick) {
    Moment coming = now_;
    coming.breeder = std::move(breeder);
    coming.offer = coming.breeder.propose(seed_);
    coming.favourite = chosen(now_.offer, pick, now_.favourite);
    past_.push_back(std::exchange(now_, std::move(coming)));
    if (past_.size() > kUndoDepth) past_.pop_front();
}

void Session::next(const genome::Pick& pick) {
    Breeder breeder = now_.breeder;
    breeder.learn(now_.offer, pick, seed_);
    go_on_with(std::move(breeder), pick);
}

void Session::turn(std::string_view name, std::optional<double> value, std::string_view source) {
    Breeder breeder = now_.breeder;
    breeder.turn(name, value, source);
    go_on_with(std::move(breeder), {});
}

void Session::choose(std::string_view name, std::string_view source) {
    Breeder breeder = now_.breeder;
    breeder.choose(name, source);
    go_on_with(std::move(breeder), {});
}

void Session::slide(std::size_t slider, int direction) {
    Breeder breeder = now_.breeder;
    breeder.slide(slider, direction);
    go_on_with(std::move(breeder), {});
}

genome::Offer Session::preview(const genome::Pick& pick) const {
    Breeder breeder = now_.breeder;
    breeder.learn(now_.offer, pick, seed_);
    return breeder.propose(seed_);
}

bool Session::undo() {
    if (past_.empty()) return false;
    const Breeder left = std::exchange(now_, std::move(past_.back())).breeder;
    past_.pop_back();
    for (const genome::Aspect aspect : genome::kAspects) now_.breeder.set_lock(aspect, left.lock(aspect));
    return true;
}

void Session::set_lock(genome::Aspect aspect, Lock lock) { now_.breeder.set_lock(aspect, lock); }

}  // namespace quadrat::breeding
