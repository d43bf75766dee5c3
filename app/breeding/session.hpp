// SPDX-License-Identifier: Apache-2.0
// The room `breeding`: learns from picks and proposes the next four. Breeders, the word map, archetypes, simulated
// visitors. Nothing here grows or shows a landscape, knows of screens and time, or keeps anything on disk.
#pragma once
#include <cstddef>
#include <deque>
#include <optional>
#include <string_view>

#include "base/seed.hpp"
#include "breeding/breeder.hpp"
#include "genome/offer.hpp"

namespace quadrat::breeding {

// One visitor's breeding: the breeder, the four on offer, and the way back. Shared by the exhibit and the protocol.
class Session {
  public:
    static constexpr std::size_t kUndoDepth = 1000;  // rounds, also taken-back ones; older ones are forgotten

    // Offers what the breeder proposes: its first four, or, for a breeder that believes what was kept, those of the
    // round it was kept in. The way back starts empty.
    Session(Breeder breeder, base::Seed seed);

    const genome::Offer& offer() const { return now().offer; }
    const Breeder& breeder() const { return now().breeder; }
    const Breeder& breeder_before() const { return can_undo() ? at(now().parent).breeder : now().breeder; }
    base::Seed seed() const { return seed_; }

    // Names the camera's path of this round's four; where sliders are turned, of the whole visit.
    base::Seed flight() const { return flight(now().offer); }
    base::Seed flight(const genome::Offer& offer) const;  // or of those that this session may offer next

    // Learns and offers the next four.
    void next(const genome::Pick& pick);

    // A slider turned, chosen or moved by a step, instead of a pick; each can be taken back like one. Throw InputError
    // as the breeder does; nothing has changed then.
    void turn(std::string_view name, std::optional<double> value, std::string_view source);
    void choose(std::string_view name, std::string_view source);
    void slide(std::size_t slider, int direction);

    // What next(pick) would offer. Aspects are independent, so as soon as an aspect is judged, that aspect of the four
    // is final and can begin to grow.
    genome::Offer preview(const genome::Pick& pick) const;

    // The session of a visitor who likes a landscape as it is: begins with what follows from its having been named best
    // in everything among the first four, itself among them. For breeders without words this session's beginning.
    Session begun_with(const genome::Candidate& liked) const;

    // What the visitor has bred so far: what the breeder believes they wish for, or, where it only compares, for each
    // aspect the candidate that was last named best; the first of the four where none was.
    genome::Candidate favourite() const { return favourite_of(here_); }

    bool can_undo() const { return is_known(now().parent); }

    // Takes the last next() back: the belief, the offer and the favourite are the former ones, exactly. Locks are a
    // standing instruction and stay as they are. False when there is nothing to take back.
    bool undo();

    // What was offered in this session is a tree: next(), turn(), choose() and slide() add to it, undo() leaves it as
    // it is. A node is numbered from 0, the first four, in the order in which they came.
    int here() const { return here_; }
    // The belief, the offer and the favourite of a node, exactly; locks as with undo(). False where it is forgotten, or
    // never was.
    bool return_to(int node);
    // The favourite of a node that is known; of one that is not, that of now.
    genome::Candidate favourite_of(int node) const;

    // Both hold from the next pick on; the four on offer stay.
    void set_lock(genome::Aspect aspect, Lock lock);
    void set_range(genome::WordId word, WordRange range) { now().breeder.set_range(word, range); }

  private:
    struct Moment {
        Breeder breeder;
        genome::Offer offer;
        genome::Candidate favourite;
        int parent = -1;
    };
    void go_on_with(Breeder breeder, const genome::Pick& pick);
    bool is_known(int node) const;
    const Moment& at(int node) const { return family_[static_cast<std::size_t>(node - first_)]; }
    const Moment& now() const { return at(here_); }
    Moment& now() { return family_[static_cast<std::size_t>(here_ - first_)]; }

    base::Seed seed_;
    std::deque<Moment> family_;
    int first_ = 0;  // that is not forgotten
    int here_ = 0;
};

// The aspects named best, put together; where an aspect was not judged, that of otherwise.
genome::Candidate chosen(const genome::Offer& offer, const genome::Pick& pick, const genome::Candidate& otherwise);

}  // namespace quadrat::breeding
