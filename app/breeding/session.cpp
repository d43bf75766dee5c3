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

Session::Session(Breeder breeder, base::Seed seed) : seed_(seed) {
    genome::Offer offer = breeder.propose(seed_);
    genome::Candidate favourite = offer.candidates.front();
    family_.push_back({std::move(breeder), std::move(offer), std::move(favourite), -1});
}

Session Session::begun_with(const genome::Candidate& liked) const {
    Breeder breeder = family_.front().breeder;
    genome::Offer first = family_.front().offer;
    if (!first.candidates.front().words) return {std::move(breeder), seed_};
    first.candidates.front() = liked;
    genome::Pick all;
    all.each.fill(0);
    breeder.learn(first, all, seed_);
    return {std::move(breeder), seed_};
}

base::Seed Session::flight(const genome::Offer& offer) const {
    const int round = now().breeder.sliders() > 0 ? 1 : offer.round;
    return seed_.child("flight").child(static_cast<std::uint64_t>(round));
}

bool Session::is_known(int node) const { return node >= first_ && node - first_ < static_cast<int>(family_.size()); }

genome::Candidate Session::favourite_of(int node) const {
    const Moment& moment = at(is_known(node) ? node : here_);
    return moment.breeder.wished(moment.favourite);
}

void Session::go_on_with(Breeder breeder, const genome::Pick& pick) {
    genome::Offer offer = breeder.propose(seed_);
    genome::Candidate favourite = chosen(now().offer, pick, now().favourite);
    family_.push_back({std::move(breeder), std::move(offer), std::move(favourite), here_});
    here_ = first_ + static_cast<int>(family_.size()) - 1;
    if (family_.size() <= kUndoDepth + 1) return;
    family_.pop_front();
    ++first_;
}

void Session::next(const genome::Pick& pick) {
    Breeder breeder = now().breeder;
    breeder.learn(now().offer, pick, seed_);
    go_on_with(std::move(breeder), pick);
}

void Session::turn(std::string_view name, std::optional<double> value, std::string_view source) {
    Breeder breeder = now().breeder;
    breeder.turn(name, value, source);
    go_on_with(std::move(breeder), {});
}

void Session::choose(std::string_view name, std::string_view source) {
    Breeder breeder = now().breeder;
    breeder.choose(name, source);
    go_on_with(std::move(breeder), {});
}

void Session::slide(std::size_t slider, int direction) {
    Breeder breeder = now().breeder;
    breeder.slide(slider, direction);
    go_on_with(std::move(breeder), {});
}

genome::Offer Session::preview(const genome::Pick& pick) const {
    Breeder breeder = now().breeder;
    breeder.learn(now().offer, pick, seed_);
    return breeder.propose(seed_);
}

bool Session::return_to(int node) {
    if (!is_known(node)) return false;
    genome::PerAspect<Lock> locks;
    for (const genome::Aspect aspect : genome::kAspects) locks[aspect] = now().breeder.lock(aspect);
    here_ = node;
    for (const genome::Aspect aspect : genome::kAspects) now().breeder.set_lock(aspect, locks[aspect]);
    return true;
}

bool Session::undo() { return return_to(now().parent); }

void Session::set_lock(genome::Aspect aspect, Lock lock) { now().breeder.set_lock(aspect, lock); }

}  // namespace quadrat::breeding
