// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/seed.hpp"
#include "breeding/belief/belief_breeder.hpp"
#include "breeding/pbil.hpp"
#include "breeding/pbil_gaussian.hpp"
#include "breeding/random_search.hpp"
#include "breeding/sliders.hpp"
#include "genome/offer.hpp"

namespace quadrat::breeding {

// Chance: as belief, but nothing is learnt; in words. What it is compared with.
enum class BreederKind { Belief, Chance, Pbil, PbilGaussian, Random, Sliders };
enum class Lock { Open, Locked };

// How a breeder is chosen and tuned, before it has learnt anything.
struct BreederOptions {
    BreederKind kind = BreederKind::Pbil;
    genome::Genome genome = genome::Genome::Classic;  // Full: in words, for the breeder that has them
    PbilOptions pbil;
    std::optional<WordMap> map;  // nothing: the default map, trained by the first breeder that asks it
    Taste taste;                 // what the site's visitors ended up with; of the belief breeder in words
    WordRanges ranges;           // what a curator allows; the belief breeder and the sliders keep to them
    friend bool operator==(const BreederOptions&, const BreederOptions&) = default;
};

// What is believed about the visitor's wish, and how picks change it. A value: a copy remembers, which is all that undo
// needs. Another breeder is another alternative of Belief and its overloads in breeder.cpp; nobody else can tell.
class Breeder {
  public:
    explicit Breeder(const BreederOptions& options);

    std::string_view name() const;  // "belief", "chance", "pbil", "pbil-gaussian", "random", "sliders"
    genome::Genome genome() const { return options_.genome; }
    const WordMap& word_map() const { return options_.map ? *options_.map : default_word_map(); }
    int round() const;  // 1, 2, …: that of the offer propose gives

    // The four candidates of this round. Depends on the belief and the seed alone. Aspects are independent: what one
    // aspect was taught changes nothing of another's bits, values or seeds.
    genome::Offer propose(base::Seed seed) const;

    // Goes on to the next round. The offer is the one that propose gave, the seed the one it was given.
    void learn(const genome::Offer& offer, const genome::Pick& pick, base::Seed seed);

    // What is learnt of a locked aspect stays exactly as it is, whatever is picked.
    void set_lock(genome::Aspect aspect, Lock lock);
    Lock lock(genome::Aspect aspect) const;

    // The landscape this visitor is believed to wish for; for breeders that only compare, what was named best.
    genome::Candidate wished(const genome::Candidate& named_best) const;

    // What a word may be from now on; the four on offer stay. Breeders without words take no notice.
    void set_range(genome::WordId word, WordRange range);

    // As the functions of SliderState; each goes on to the next round. Throw InputError for breeders without sliders.
    void turn(std::string_view name, std::optional<double> value, std::string_view source);
    void choose(std::string_view name, std::string_view source);

    // The numbered slider, and what a step of it does. Nothing, and no effect, for breeders without sliders.
    std::size_t sliders() const;
    std::optional<SliderPosition> slider(std::size_t number) const;
    void slide(std::size_t number, int direction);

    // Of the belief breeder in words, what is believed; null for others, and where nothing is learnt.
    const BeliefState* layered_belief() const;

    // What is believed, for people and programs to read: {"trees":[0.5,…],…}, the probability of a 1, a bit; of the
    // belief breeder {"trees":{"tall":{"mean":0.1,"deviation":0.4},…},…}; of sliders where they stand.
    std::string state_json() const;

    // The belief as it is kept on disk, exact: b.believe(b.belief_json()) changes nothing.
    std::string belief_json() const;

    // Throws InputError naming source, the key, what is wrong and what would be right; the belief is then as before.
    void believe(std::string_view belief_json, std::string_view source);

    friend bool operator==(const Breeder&, const Breeder&) = default;

  private:
    using Belief = std::variant<PbilState, PbilGaussianState, RandomState, BeliefState, SliderState>;

    SliderState& require_sliders(std::string_view source);

    BreederOptions options_;
    Belief belief_;
};

// "belief", "chance", "pbil", "pbil-gaussian", "random", "sliders". Throws InputError naming the known ones.
BreederKind breeder_named(std::string_view name);

}  // namespace quadrat::breeding
