// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <vector>

#include "base/seed.hpp"
#include "breeding/belief/wish.hpp"
#include "breeding/words/described_scene.hpp"
#include "genome/offer.hpp"

namespace quadrat::breeding {

enum class World { Anywhere, NearArchetypes };  // where wishes lie
enum class Noise { None, Mild, Strong };        // how well a visitor sees what is nearer

std::string_view name_of(World world);
std::string_view name_of(Noise noise);
double tau_of(Noise noise);  // of Plackett and Luce's choice; a random scene is 1 from the wish

// A simulated visitor: has one landscape in mind, cares for few parameters much, sees differences saturate and
// parameters interact, and names one of four by Plackett and Luce; one pick in ten means nothing. It ranks methods; it
// does not predict people.
class SimulatedVisitor {
  public:
    // Wishes near archetypes are mixtures of three of those given, with a personal residue.
    SimulatedVisitor(genome::Genome genome, World world, Noise noise,
                     const genome::PerAspect<std::vector<Place>>& archetypes, base::Seed seed);

    // How far an aspect is from the wish: 0 there, 1 for a random scene on average.
    double distance(const Place& place, genome::Aspect aspect) const;
    double distance(const genome::ParameterValues& values) const;  // root mean square over the aspects

    // 1 at the wish, 0 as far as random scenes are on average, below it farther.
    double closeness(const genome::ParameterValues& values) const { return 1 - distance(values) / random_distance_; }

    // Which of the places they name best.
    std::size_t pick(std::span<const Place> places, genome::Aspect aspect, base::RandomStream& chance) const;

    // The same eye, that wishes this share of its parameters as another visitor does; the more, the larger the share.
    // In between of two wishes it would be content with the average.
    SimulatedVisitor drifted(const SimulatedVisitor& to, double share) const;

    // For slider users, who know what each slider should be, more or less.
    const Place& wish(genome::Aspect aspect) const { return aspects_[aspect].wish; }
    const std::vector<double>& weights(genome::Aspect aspect) const { return aspects_[aspect].weights; }
    double seen(double distance, base::RandomStream& chance) const;  // with the eye's noise

    genome::Genome genome() const { return genome_; }
    Noise noise() const { return noise_; }

  private:
    struct Eye {
        Place wish;
        std::vector<double> weights;                       // sum 1
        std::vector<std::array<std::size_t, 2>> together;  // judged by their product
        std::vector<std::size_t> gate;                     // counts as much as that one is high; itself: always
        double norm = 1;
    };
    double raw_distance(const Eye& eye, const Place& place) const;

    genome::Genome genome_;
    Noise noise_;
    genome::PerAspect<Eye> aspects_;
    double random_distance_ = 1;
};

}  // namespace quadrat::breeding
