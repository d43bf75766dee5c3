// SPDX-License-Identifier: Apache-2.0
#include "breeding/simulation/player.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "breeding/belief/coordinates.hpp"
#include "breeding/words/nearest_words.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::kAspects;
using Places = genome::PerAspect<Place>;

genome::ParameterValues values_of(const Places& places, genome::Genome genome) {
    genome::ParameterValues values;
    for (const Aspect aspect : kAspects) set_values(values, genome, aspect, places[aspect]);
    return values;
}

Places middle(genome::Genome genome) {
    Places places;
    for (const Aspect aspect : kAspects) places[aspect].assign(parameters_of(aspect, genome).size(), 0.5);
    return places;
}

// A breeder, played over the same offers and picks as the exhibit's.
class Visit : public Player {
  public:
    Visit(BreederKind kind, genome::Genome genome, const WordMap& map, base::Seed seed)
        : session_(breeder_of(kind, genome, map), seed) {}

    void play_round(const SimulatedVisitor& visitor, base::RandomStream& chance) override {
        genome::Pick pick;
        double squares = 0;
        for (const Aspect aspect : kAspects) {
            std::vector<Place> places;
            double nearest = 1e9;
            for (const genome::Candidate& candidate : session_.offer().candidates) {
                places.push_back(place_of(candidate.values, visitor.genome(), aspect));
                nearest = std::min(nearest, visitor.distance(places.back(), aspect));
            }
            squares += nearest * nearest / static_cast<double>(kAspects.size());
            pick[aspect] = visitor.pick(places, aspect, chance);
        }
        best_shown_ = std::sqrt(squares);
        session_.next(pick);
    }
    genome::ParameterValues taken_home() const override { return session_.favourite().values; }
    std::optional<double> best_shown() const override { return best_shown_; }

  private:
    static Breeder breeder_of(BreederKind kind, genome::Genome genome, const WordMap& map) {
        BreederOptions options;
        options.kind = kind;
        options.genome = genome;
        options.map = map;
        return Breeder(options);
    }

    Session session_;
    std::optional<double> best_shown_;
};

// The 2003 paper's searches that learn nothing: four scenes a round, of which, with the best so far, the best is kept.
class Search : public Player {
  public:
    Search(Method method, genome::Genome genome, const WordMap& map)
        : method_(method), genome_(genome), kept_(middle(genome)) {
        for (const Aspect aspect : kAspects) archetypes_[aspect] = named_places(map.scenes(), genome, aspect);
    }

    void play_round(const SimulatedVisitor& visitor, base::RandomStream& chance) override {
        double squares = 0;
        for (const Aspect aspect : kAspects) {
            std::vector<Place> places;
            for (std::size_t k = 0; k < genome::kCandidates; ++k) places.push_back(next_place(aspect, k, chance));
            double nearest = 1e9;
            for (const Place& place : places) nearest = std::min(nearest, visitor.distance(place, aspect));
            squares += nearest * nearest / static_cast<double>(kAspects.size());
            if (has_kept_) places.push_back(kept_[aspect]);
            kept_[aspect] = places[visitor.pick(places, aspect, chance)];
        }
        has_kept_ = true;
        best_shown_ = std::sqrt(squares);
        ++round_;
    }
    genome::ParameterValues taken_home() const override { return values_of(kept_, genome_); }
    std::optional<double> best_shown() const override { return best_shown_; }

  private:
    Place next_place(Aspect aspect, std::size_t k, base::RandomStream& chance) {
        Place place(parameters_of(aspect, genome_).size());
        if (method_ == Method::Exhaustive) return counted(genome_, aspect, round_ * genome::kCandidates + k);
        for (std::size_t i = 0; i < place.size(); ++i) {
            double low = 0;
            double high = 1;
            if (method_ == Method::BiasedRandom && !archetypes_[aspect].empty()) {
                low = 1;
                high = 0;
                for (const Place& one : archetypes_[aspect]) {
                    low = std::min(low, one[i]);
                    high = std::max(high, one[i]);
                }
            }
            place[i] = low + (high - low) * chance.unit();
        }
        return place;
    }

    // The number-th bit string, read as a number with the aspect's first parameter in its lowest bits.
    static Place counted(genome::Genome genome, Aspect aspect, std::size_t number) {
        genome::BitGenome bits;
        for (const Aspect each : kAspects) bits[each].assign(bit_count(each, genome), 0);
        for (std::size_t b = 0; b < bits[aspect].size() && b < 64; ++b)
            bits[aspect][b] = static_cast<genome::Bits::value_type>((number >> b) & 1U);
        return place_of(decode(bits, genome), genome, aspect);
    }

    Method method_;
    genome::Genome genome_;
    genome::PerAspect<std::vector<Place>> archetypes_;
    Places kept_;
    bool has_kept_ = false;
    std::size_t round_ = 0;
    std::optional<double> best_shown_;
};

// The paper's rival: one parameter at a time is set to what the visitor has in mind, and left so if it looks better.
class Sliders : public Player {
  public:
    Sliders(genome::Genome genome, int moves, bool is_skilled, base::Seed seed)
        : genome_(genome), moves_(moves), is_skilled_(is_skilled), places_(middle(genome)) {
        base::RandomStream chance(seed.child("order"));
        for (const Aspect aspect : kAspects)
            for (std::size_t i = 0; i < places_[aspect].size(); ++i) order_.push_back({aspect, i});
        for (std::size_t i = order_.size(); i > 1; --i)
            std::swap(order_[i - 1], order_[chance.below(static_cast<std::uint32_t>(i))]);
    }

    void play_round(const SimulatedVisitor& visitor, base::RandomStream& chance) override {
        for (int move = 0; move < moves_; ++move) {
            const Slider slider = is_skilled_ ? most_wrong(visitor, chance) : order_[next_++ % order_.size()];
            turn(visitor, slider, chance);
        }
    }
    genome::ParameterValues taken_home() const override { return values_of(places_, genome_); }

  private:
    struct Slider {
        Aspect aspect;
        std::size_t index;
    };

    static double hand_of(Noise noise) { return noise == Noise::None ? 0.03 : noise == Noise::Mild ? 0.10 : 0.20; }

    Slider most_wrong(const SimulatedVisitor& visitor, base::RandomStream& chance) const {
        Slider worst = order_.front();
        double most = -1;
        for (const Slider& slider : order_) {
            const double wrong =
                std::abs(places_[slider.aspect][slider.index] - visitor.wish(slider.aspect)[slider.index]);
            const double seen = std::sqrt(visitor.weights(slider.aspect)[slider.index]) * wrong *
                                (1 + hand_of(visitor.noise()) * 3 * static_cast<double>(chance.normal()));
            if (seen <= most) continue;
            most = seen;
            worst = slider;
        }
        return worst;
    }

    void turn(const SimulatedVisitor& visitor, const Slider& slider, base::RandomStream& chance) {
        Place& place = places_[slider.aspect];
        const Place before = place;
        const double aim =
            visitor.wish(slider.aspect)[slider.index] + hand_of(visitor.noise()) * static_cast<double>(chance.normal());
        place[slider.index] = std::clamp(aim, 0.0, 1.0);
        const double now = visitor.seen(visitor.distance(place, slider.aspect), chance);
        const double then = visitor.seen(visitor.distance(before, slider.aspect), chance);
        if (is_skilled_ && now > then) place = before;
    }

    genome::Genome genome_;
    int moves_;
    bool is_skilled_;
    Places places_;
    std::vector<Slider> order_;
    std::size_t next_ = 0;
};

// Stands still: the average scene, or the nearest archetype.
class Still : public Player {
  public:
    explicit Still(const genome::ParameterValues& values) : values_(values) {}
    void play_round(const SimulatedVisitor&, base::RandomStream&) override {}
    genome::ParameterValues taken_home() const override { return values_; }

  private:
    genome::ParameterValues values_;
};

genome::ParameterValues nearest_archetypes(const SimulatedVisitor& visitor, const WordMap& map) {
    Places nearest = middle(visitor.genome());
    for (const Aspect aspect : kAspects) {
        const auto places = named_places(map.scenes(), visitor.genome(), aspect);
        const auto near =
            std::ranges::min_element(places, {}, [&](const Place& place) { return visitor.distance(place, aspect); });
        if (near != places.end()) nearest[aspect] = *near;
    }
    return values_of(nearest, visitor.genome());
}

genome::ParameterValues projected(const SimulatedVisitor& visitor, const WordMap& map) {
    genome::Description words;
    for (const Aspect aspect : kAspects)
        words = nearest_words(map, aspect, words, [&](const genome::ParameterValues& values) {
            return visitor.distance(place_of(values, visitor.genome(), aspect), aspect);
        });
    return map(words);
}

}  // namespace

std::vector<Method> all_methods() {
    std::vector<Method> methods;
    for (int m = 0; m <= static_cast<int>(Method::Projection); ++m) methods.push_back(static_cast<Method>(m));
    return methods;
}

std::string_view name_of(Method method) {
    constexpr std::array<std::string_view, 13> kNames{"no pick",
                                                      "random",
                                                      "biased random",
                                                      "exhaustive",
                                                      "pbil",
                                                      "pbil-gaussian",
                                                      "belief",
                                                      "sliders, skilled, 1 move",
                                                      "sliders, skilled, 3 moves",
                                                      "sliders, novice, 3 moves",
                                                      "sliders, novice, 10 moves",
                                                      "best archetype",
                                                      "projected on the words"};
    return kNames[static_cast<std::size_t>(method)];
}

std::unique_ptr<Player> player(Method method, const SimulatedVisitor& visitor, const WordMap& map, base::Seed seed) {
    const genome::Genome genome = visitor.genome();
    switch (method) {
        case Method::NoPick:
            return std::make_unique<Still>(values_of(middle(genome), genome));
        case Method::Random:
        case Method::BiasedRandom:
        case Method::Exhaustive:
            return std::make_unique<Search>(method, genome, map);
        case Method::Pbil:
            return std::make_unique<Visit>(BreederKind::Pbil, genome, map, seed);
        case Method::PbilGaussian:
            return std::make_unique<Visit>(BreederKind::PbilGaussian, genome, map, seed);
        case Method::Belief:
            return std::make_unique<Visit>(BreederKind::Belief, genome, map, seed);
        case Method::SlidersSkilled1:
            return std::make_unique<Sliders>(genome, 1, true, seed);
        case Method::SlidersSkilled3:
            return std::make_unique<Sliders>(genome, 3, true, seed);
        case Method::SlidersNovice3:
            return std::make_unique<Sliders>(genome, 3, false, seed);
        case Method::SlidersNovice10:
            return std::make_unique<Sliders>(genome, 10, false, seed);
        case Method::Projection:
            return std::make_unique<Still>(projected(visitor, map));
        case Method::BestArchetype:
            break;
    }
    return std::make_unique<Still>(nearest_archetypes(visitor, map));
}

}  // namespace quadrat::breeding
