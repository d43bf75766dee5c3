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

base::Seed Session::flight() const { return seed_.child("flight").child(now_.offer.round); }

void Session::next(const genome::Pick& pick) {
    Moment coming = now_;
    coming.breeder.learn(now_.offer, pick, seed_);
    coming.offer = coming.breeder.propose(seed_);
    coming.favourite = chosen(now_.offer, pick, now_.favourite);
    past_.push_back(std::exchange(now_, std::move(coming)));
    if (past_.size() > kUndoDepth) past_.pop_front();
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
